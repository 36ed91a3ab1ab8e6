// SPDX-License-Identifier: MIT
//
// The chart of the stability run. The paper's tolerance question as a curve: verdicts that contradict the
// exact one, against the distance up to which a pair counts as touching; too small a tolerance leaves
// rounding to decide, too large a one calls separated pairs touching. Table types that answer alike share a
// curve, which names them.
#include <map>
#include <tuple>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// Tolerance 0 has no place on a logarithmic axis; it is drawn left of all other tolerances.
constexpr double place_of_zero = 1e-18;

/// Number of wrong verdicts, and of the cases that gave a verdict.
struct WrongVerdicts {
    double wrong = 0, cases = 0;
};

/// Percent of wrong verdicts by tolerance.
using ToleranceCurve = std::map<double, double>;

/// Returns the curves by algorithm and table type.
std::map<std::pair<std::string, std::string>, ToleranceCurve> tolerance_curves(const ReportData& data) {
    constexpr store::FigureName failures("stability.failures_at_{tolerance}");
    std::map<std::pair<std::string, std::string>, std::map<double, WrongVerdicts>> sums;
    for (const ReportCell& row : data.stability) {
        const double cases = row.figure("stability.cases").value.value_or(0);
        for (const store::FigureRow& figure : row.figures) {
            const auto at = failures.value_in(figure.probe, figure.name);
            if (!at || !figure.value) continue;
            // By number: the names' order is not that of the tolerances.
            WrongVerdicts& sum = sums[{row.algorithm, row.table}][std::stod(*at)];
            sum.wrong += *figure.value, sum.cases += cases;
        }
    }
    std::map<std::pair<std::string, std::string>, ToleranceCurve> curves;
    for (const auto& [name, points] : sums)
        for (const auto& [tolerance, sum] : points)
            if (sum.cases > 0) curves[name][tolerance] = 100 * sum.wrong / sum.cases;
    return curves;
}

/// Returns the members that name an algorithm on a table type.
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
    std::map<std::pair<std::string, ToleranceCurve>, std::vector<std::string>> alike;
    for (const auto& [name, curve] : tolerance_curves(data))
        alike[{name.first, curve}].push_back(name.second);
    ChartRows rows;
    for (const auto& [key, tables] : alike) {
        ChartJson named = table_json(data, key.first, tables.front());
        std::string names;
        for (const std::string& table : tables) append(names, table);
        named["table"] = names;
        for (const auto& [tolerance, share] : key.second) {
            ChartJson row = named;
            row["tolerance"] = tolerance > 0 ? tolerance : place_of_zero;
            row["share"] = share;
            rows.values.push_back(std::move(row));
        }
    }
    return drawn_chart(chart_of_file("tolerance"), data, std::move(rows));
}

}  // namespace edgewise::reports
