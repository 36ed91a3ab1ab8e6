// SPDX-License-Identifier: MIT
//
// The paper's tolerance question as a curve: verdicts that contradict the exact one, against the distance up
// to which a pair counts as touching. Too small a tolerance leaves rounding to decide, too large a one calls
// separated pairs touching.
#include <map>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

/// Tolerance 0 has no place on a logarithmic axis; it stands left of all others.
constexpr double place_of_zero = 1e-18;

struct Sum {
    double failures = 0, cases = 0;
};

/// Algorithm, table type and tolerance -> failures and cases over all families.
using Sums = std::map<std::tuple<std::string, std::string, double>, Sum>;

Sums sums_of(const ReportData& data) {
    Sums sums;
    for (const StabilityFigure& figure : stability_figures(data, "stability.failures_at_{tolerance}")) {
        Sum& sum = sums[{figure.row->algorithm, figure.row->table, std::stod(figure.at)}];
        sum.failures += figure.value;
        sum.cases += figure.row->figure("stability.cases").value.value_or(0);
    }
    return sums;
}

ChartJson values_of(const ReportData& data) {
    ChartJson values = ChartJson::array();
    for (const auto& [key, sum] : sums_of(data)) {
        const auto& [algorithm, table, tolerance] = key;
        if (!(sum.cases > 0)) continue;
        ChartJson value = table_json(data, algorithm, table);
        value["tolerance"] = tolerance > 0 ? tolerance : place_of_zero;
        value["share"] = 100 * sum.failures / sum.cases;
        values.push_back(std::move(value));
    }
    return values;
}

ChartJson x_axis() {
    return {{"field", "tolerance"},
            {"type", "quantitative"},
            {"title", "contact tolerance, of scale (leftmost: 0)"},
            {"scale", {{"type", "log"}}},
            {"axis", {{"format", ".0e"}, {"tickCount", 8}}}};
}

}  // namespace

Chart tolerance_chart(const ReportData& data) {
    Chart chart{
        "tolerance",
        "Verdicts against the contact tolerance",
        "Each line is an algorithm on a table type over all hard families: the share of verdicts that "
        "contradict exact arithmetic when pairs nearer than the tolerance (relative to their scale) count "
        "as touching. The leftmost point is tolerance 0. Flat to the left means that no tolerance is "
        "needed; the rise to the right is separated pairs called touching.",
        nullptr,
        {},
        {}};
    const ChartJson values = values_of(data);
    if (values.empty()) return chart;
    const ChartJson y{{"field", "share"}, {"type", "quantitative"}, {"title", "verdicts that differ, %"}};
    chart.spec = table_lines(data, values, x_axis(), y);
    chart.fallback = data_grid(values, {"algorithm", "table", "tolerance", "share"});
    return chart;
}

}  // namespace edgewise::reports
