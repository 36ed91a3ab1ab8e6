// SPDX-License-Identifier: MIT
//
// What tables of seeds buy for their bytes: cells of `lean` and of its variants with seeds, in scenes where
// queries start far from their answers: all of them cold, or in a random orientation each.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

constexpr store::FigureName table_bytes("bytes.table_bytes");

const FigureColumn seed_columns[] = {{"ns per query", "time.all_ns", 1, 0},
                                     {"steps", store::mean_steps.all, 1, 2},
                                     {"lines", store::lines_read.all, 1, 1}};

/// How the scene's queries start, if all of them start far from their answers; else nothing.
std::string far_start(const ReportCell& cell) {
    if (cell.scene == "cold") return "cold";
    const auto parameters = input::json_or_null(cell.scene_parameters);
    const bool random =
        cell.scene == "tumble" && parameters.is_object() && parameters.value("random_orientation", 0.0) != 0;
    return random ? "random orientation" : "";
}

/// Plain cells alone: their table is the type's name.
bool has_or_lacks_seeds(const ReportCell& cell) {
    return cell.verified() && cell.table == cell.layout + "_" + cell.precision &&
           (cell.layout == "lean" || cell.layout.starts_with("lean_seeds")) && !far_start(cell).empty() &&
           cell.figure(table_bytes).value.has_value();
}

auto comparison_of(const ReportCell& cell) {
    return std::make_tuple(far_start(cell), cell.scene_label, cell.vertices, cell.shape, cell.algorithm,
                           cell.precision);
}

}  // namespace

std::vector<SeededCell> seeded_cells(const ReportData& data) {
    std::map<decltype(comparison_of(data.cells[0])), const ReportCell*> without;
    for (const ReportCell& cell : data.cells)
        if (has_or_lacks_seeds(cell) && cell.layout == "lean") without.emplace(comparison_of(cell), &cell);
    std::vector<SeededCell> all;
    for (const ReportCell& cell : data.cells) {
        if (!has_or_lacks_seeds(cell) || cell.layout == "lean") continue;
        const auto plain = without.find(comparison_of(cell));
        if (plain == without.end()) continue;
        const double bytes = *cell.figure(table_bytes).value - *plain->second->figure(table_bytes).value;
        all.push_back({&cell, far_start(cell), bytes});
        all.push_back({plain->second, far_start(cell), 0});
    }
    const auto place = [](const SeededCell& of) {
        return std::make_tuple(comparison_of(*of.cell), of.seed_bytes, of.cell);
    };
    std::sort(all.begin(), all.end(),
              [&](const SeededCell& a, const SeededCell& b) { return place(a) < place(b); });
    const auto same = [](const SeededCell& a, const SeededCell& b) { return a.cell == b.cell; };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
}

TextGrid seeds_grid(const ReportData& data) {
    TextGrid grid = figure_grid("Seeds, by their bytes",
                                "start|shape|algorithm|table type|#more bytes per table", seed_columns);
    for (const SeededCell& of : seeded_cells(data))
        add_row(grid,
                grid_row(of.starts, of.cell->shape, of.cell->algorithm, of.cell->table,
                         static_cast<std::int64_t>(of.seed_bytes)),
                *of.cell, seed_columns);
    return grid;
}

}  // namespace edgewise::reports
