// SPDX-License-Identifier: MIT
//
// Time against signed gap: what nearness and overlap cost, over all hard families.
#include <algorithm>
#include <map>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

double middle(std::vector<double> sample) {
    std::sort(sample.begin(), sample.end());
    const std::size_t half = sample.size() / 2;
    return sample.size() % 2 == 1 ? sample[half] : (sample[half - 1] + sample[half]) / 2;
}

/// From deep inside to far apart.
const std::vector<std::string>& gap_order() {
    static const std::vector<std::string> order = {"-1e-01", "-1e-03", "-1e-06", "-1e-09", "0",
                                                   "1e-09",  "1e-06",  "1e-03",  "1e-01"};
    return order;
}

/// Algorithm, table type and bin -> the figure of every family that has it.
using Samples = std::map<std::tuple<std::string, std::string, std::string>, std::vector<double>>;

ChartJson values_of(const ReportData& data) {
    Samples samples;
    for (const StabilityFigure& figure : stability_figures(data, "stability.ns_at_{gap}"))
        samples[{figure.row->algorithm, figure.row->table, figure.at}].push_back(figure.value);
    ChartJson values = ChartJson::array();
    for (const auto& [key, sample] : samples) {
        const auto& [algorithm, table, gap] = key;
        ChartJson value = table_json(data, algorithm, table);
        value["gap"] = gap;
        value["families"] = sample.size();
        value["ns"] = middle(sample);
        values.push_back(std::move(value));
    }
    return values;
}

ChartJson x_axis() {
    return {{"field", "gap"},
            {"type", "ordinal"},
            {"title", "signed gap, of scale"},
            {"sort", gap_order()},
            {"axis", {{"labelAngle", 0}}}};
}

}  // namespace

Chart gap_chart(const ReportData& data) {
    Chart chart{
        "gap",
        "Time against signed gap",
        "Cold queries of the hard families, binned by the exact gap over the scale of the pair: each bin "
        "from its label up to the next, negative where the bodies overlap, 0 for everything nearer than "
        "1e-9. A point is the median over families. Close pairs cost more where an answer is worked out "
        "again in wider arithmetic.",
        nullptr,
        {},
        {}};
    const ChartJson values = values_of(data);
    if (values.empty()) return chart;
    const ChartJson y{
        {"field", "ns"}, {"type", "quantitative"}, {"title", "ns a cold query"}, {"scale", log_scale()}};
    chart.spec = table_lines(data, values, x_axis(), y);
    chart.fallback = data_grid(values, {"algorithm", "table", "gap", "families", "ns"});
    return chart;
}

}  // namespace edgewise::reports
