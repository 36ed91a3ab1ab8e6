// SPDX-License-Identifier: MIT
//
// The charts of the stability run. The paper's tolerance question as a curve: verdicts that contradict the
// exact one, against the distance up to which a pair counts as touching; too small a tolerance leaves
// rounding to decide, too large a one calls separated pairs touching. And time against signed gap: what
// nearness and overlap cost, over all hard families.
#include <map>
#include <tuple>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/reports/charts/charts.hpp"

namespace edgewise::reports {

namespace {

/// Tolerance 0 has no place on a logarithmic axis; it stands left of all others.
constexpr double place_of_zero = 1e-18;

/// A figure of a family of figures, and the cases of its row.
struct StabilityFigure {
    double value, cases;
};

/// Algorithm, table type and what a figure's name has for the braces -> that figure of every row that has it.
using StabilityFigures =
    std::map<std::tuple<std::string, std::string, std::string>, std::vector<StabilityFigure>>;

StabilityFigures stability_figures(const ReportData& data, const store::FigureName& family) {
    StabilityFigures found;
    for (const ReportCell& row : data.stability) {
        const double cases = row.figure("stability.cases").value.value_or(0);
        for (const store::FigureRow& figure : row.figures)
            if (const auto at = family.value_in(figure.probe, figure.name); at && figure.value)
                found[{row.algorithm, row.table, *at}].push_back({*figure.value, cases});
    }
    return found;
}

/// What names an algorithm on a table type.
ChartJson table_json(const ReportData& data, const std::string& algorithm, const std::string& table) {
    ChartJson result{{"algorithm", algorithm}, {"table", table}};
    for (const ReportCell& row : data.stability) {
        if (row.table != table) continue;
        result["layout"] = row.layout;
        result["precision"] = row.precision;
        break;
    }
    return result;
}

}  // namespace

Chart tolerance_chart(const ReportData& data) {
    // By number: the names' order is not that of the tolerances.
    std::map<std::tuple<std::string, std::string, double>, StabilityFigure> sums;
    for (const auto& [key, figures] : stability_figures(data, "stability.failures_at_{tolerance}")) {
        const auto& [algorithm, table, at] = key;
        StabilityFigure& sum = sums[{algorithm, table, std::stod(at)}];
        for (const StabilityFigure& figure : figures) sum.value += figure.value, sum.cases += figure.cases;
    }
    ChartRows rows;
    for (const auto& [key, sum] : sums) {
        const auto& [algorithm, table, tolerance] = key;
        if (!(sum.cases > 0)) continue;
        ChartJson row = table_json(data, algorithm, table);
        row["tolerance"] = tolerance > 0 ? tolerance : place_of_zero;
        row["share"] = 100 * sum.value / sum.cases;
        rows.values.push_back(std::move(row));
    }
    return drawn_chart(chart_of_file("tolerance"), data, std::move(rows));
}

Chart gap_chart(const ReportData& data) {
    ChartRows rows;
    for (const auto& [key, figures] : stability_figures(data, "stability.ns_at_{gap}")) {
        const auto& [algorithm, table, gap] = key;
        std::vector<double> times;
        for (const StabilityFigure& figure : figures) times.push_back(figure.value);
        const auto ns = measure::median(times);
        if (!ns) continue;
        ChartJson row = table_json(data, algorithm, table);
        row["gap"] = gap;
        row["families"] = times.size();
        row["ns"] = *ns;
        rows.values.push_back(std::move(row));
    }
    return drawn_chart(chart_of_file("gap"), data, std::move(rows));
}

}  // namespace edgewise::reports
