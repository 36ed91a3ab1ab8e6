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

/// Algorithm, table type and bin -> the figure of every family that has it.
using Samples = std::map<std::tuple<std::string, std::string, std::string>, std::vector<double>>;

ChartJson gap_values_of(const ReportData& data) {
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

}  // namespace

Chart gap_chart(const ReportData& data) {
    Chart chart = chart_of_file("gap");
    ChartJson values = gap_values_of(data);
    if (take_rows(chart, values)) draw(chart, data, values);
    return chart;
}

}  // namespace edgewise::reports
