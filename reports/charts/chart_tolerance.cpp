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

struct ToleranceSum {
    double failures = 0, cases = 0;
};

/// Algorithm, table type and tolerance -> failures and cases over all families.
using Sums = std::map<std::tuple<std::string, std::string, double>, ToleranceSum>;

Sums sums_of(const ReportData& data) {
    Sums sums;
    for (const StabilityFigure& figure : stability_figures(data, "stability.failures_at_{tolerance}")) {
        ToleranceSum& sum = sums[{figure.row->algorithm, figure.row->table, std::stod(figure.at)}];
        sum.failures += figure.value;
        sum.cases += figure.row->figure("stability.cases").value.value_or(0);
    }
    return sums;
}

ChartJson tolerance_values_of(const ReportData& data) {
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

}  // namespace

Chart tolerance_chart(const ReportData& data) {
    Chart chart = chart_of_file("tolerance");
    ChartJson values = tolerance_values_of(data);
    if (take_rows(chart, values)) draw(chart, data, values);
    return chart;
}

}  // namespace edgewise::reports
