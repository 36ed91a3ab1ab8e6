// SPDX-License-Identifier: MIT
//
// What a layout costs beside its own bytes: cache lines that queries touch, time to build and to refit, in
// one scene with one shape (results.csv has all); and the memory of scenes with many tables.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <tuple>

#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

constexpr double layout_mebibyte = 1 << 20;

/// The warm scene if there is one: its queries are what layouts are for.
std::string reference_scene(const ReportData& data) {
    std::string first;
    for (const ReportCell& cell : data.cells) {
        if (cell.scene == "tumble") return cell.scene_label;
        if (first.empty()) first = cell.scene_label;
    }
    return first;
}

/// The figure's number divided, with this many digits; or why there is none.
GridCell scaled_cell(const measure::Figure& figure, double unit, int digits) {
    if (!figure.value) return figure_cell(figure);
    return {fmt::format("{:.{}f}", *figure.value / unit, digits)};
}

std::vector<GridCell> cost_row(const ReportCell& cell) {
    return grid_row(cell.algorithm, cell.table, scaled_cell(cell.figure("lines.lines_per_query"), 1, 1),
                    scaled_cell(cell.figure("lines.line_bytes_per_query"), 1, 0),
                    scaled_cell(cell.figure("lines.read_bytes_per_query"), 1, 0),
                    scaled_cell(cell.figure("build.build_ns"), 1000, 1),
                    scaled_cell(cell.figure("build.refit_ns"), 1000, 1),
                    scaled_cell(cell.figure("build.refit_over_build"), 1, 2),
                    scaled_cell(cell.figure("memory.materialised"), 1, 3));
}

double lines_of(const ReportCell& cell) {
    return cell.figure("lines.lines_per_query").value.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

TextGrid layout_cost_grid(const ReportData& data) {
    const std::string scene = reference_scene(data), shape = reference_shape(data);
    TextGrid grid{
        fmt::format("{}, {}, fewest lines first", scene, shape),
        columns_of("algorithm|table type|#lines per query|#their bytes|#bytes read|#build, us|#refit, us|"
                   "#refit / build|#materialised"),
        {}};
    std::vector<const ReportCell*> cells;
    for (const ReportCell& cell : data.cells)
        if (cell.verified() && cell.scene_label == scene && cell.shape == shape) cells.push_back(&cell);
    std::stable_sort(cells.begin(), cells.end(), [](const ReportCell* a, const ReportCell* b) {
        return std::make_tuple(b->algorithm, lines_of(*a)) < std::make_tuple(a->algorithm, lines_of(*b));
    });
    for (const ReportCell* cell : cells) grid.rows.push_back(cost_row(*cell));
    return grid;
}

TextGrid scene_memory_grid(const ReportData& data) {
    TextGrid grid{
        "Cells with more than four tables",
        columns_of("scene|shape|algorithm|table type|#tables|#asked for, MiB|#taken, MiB|#resident, MiB|"
                   "#ns per query|#ratio to baseline"),
        {}};
    for (const ReportCell& cell : data.cells) {
        const measure::Figure tables = cell.figure("memory.tables");
        const bool many = tables.value && *tables.value > 4;
        if (!cell.verified() || !many) continue;
        grid.rows.push_back(grid_row(cell.scene_label, cell.shape, cell.algorithm, cell.table,
                                     scaled_cell(tables, 1, 0),
                                     scaled_cell(cell.figure("memory.requested_bytes"), layout_mebibyte, 2),
                                     scaled_cell(cell.figure("memory.taken_bytes"), layout_mebibyte, 2),
                                     scaled_cell(cell.figure("memory.resident_bytes"), layout_mebibyte, 2),
                                     scaled_cell(cell.figure("time.separated_ns"), 1, 0),
                                     scaled_cell(cell.figure("time.separated_ratio"), 1, 3)));
    }
    return grid;
}

std::vector<Drawing> drawings(const ReportData& data) {
    constexpr std::string_view prefix = store::drawing_key;
    std::vector<Drawing> result;
    for (const auto& [key, value] : data.meta) {
        if (key.starts_with(prefix)) result.push_back({key.substr(prefix.size()), value});
    }
    return result;
}

}  // namespace edgewise::reports
