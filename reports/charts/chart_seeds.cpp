// SPDX-License-Identifier: MIT
//
// The seed curve: time, steps and lines of a query against the bytes of the table's seeds, a column of panels
// for each number, a row for each scene and shape.
#include <string>
#include <utility>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

struct Number {
    const char* name;
    store::FigureName figure;
};
const Number numbers[] = {{"ns per query", "time.all_ns"},
                          {"steps per query", store::mean_steps.all},
                          {"lines of 64 bytes per query", store::lines_read.all}};

ChartRows seed_rows(const ReportData& data) {
    ChartRows rows;
    for (const SeededCell& of : seeded_cells(data)) {
        for (const Number& number : numbers) {
            const auto value = rows.omitted.positive(of.cell->figure(number.figure), "it is 0",
                                                     std::string(number.name) + ": ");
            if (!value) continue;
            ChartJson row = cell_json(*of.cell);
            row["of"] = of.starts + ", " + std::to_string(of.cell->vertices) + " vertices";
            row["number"] = number.name;
            row["seed_bytes"] = of.seed_bytes;
            row["value"] = *value;
            rows.values.push_back(std::move(row));
        }
    }
    return rows;
}

}  // namespace

Chart seeds_chart(const ReportData& data) {
    ChartRows rows = seed_rows(data);
    ChartJson panels = ChartJson::array();  // by start, then by size
    for (const ChartJson& row : rows.values)
        if (panels.empty() || panels.back() != row["of"]) panels.push_back(row["of"]);
    return drawn_chart(chart_of_file("seeds"), data, std::move(rows), {{"panels", panels}}, "number");
}

}  // namespace edgewise::reports
