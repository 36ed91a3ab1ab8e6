// SPDX-License-Identifier: MIT
//
// What a layout costs beside its own bytes, in one scene with one shape (results/ has all): cache lines
// that queries touch, time to build and to refit; what was counted and what the heap took. And the memory of
// scenes with many tables.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <tuple>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

constexpr store::FigureName line_bytes("lines.line_bytes_per_query.{start}"),
    bytes_read("lines.read_bytes_per_query.{start}");

const FigureColumn layout_cost_columns[] = {
    {"lines per warm query", store::lines_read.warm(), 1, 1},
    {"their bytes", line_bytes.of(store::StartNames::warm_start), 1, 0},
    {"bytes read", bytes_read.of(store::StartNames::warm_start), 1, 0},
    {"build, us", "build.build_ns", 1000, 1},
    {"refit, us", "build.refit_ns", 1000, 1},
    {"refit / build", "build.refit_over_build", 1, 2},
    {"materialised", "memory.materialised", 1, 3}};

const FigureColumn scene_memory_columns[] = {{"tables", "memory.tables", 1, 0},
                                             {"asked for, MiB", "memory.requested_bytes", mebibyte, 2},
                                             {"taken, MiB", "memory.taken_bytes", mebibyte, 2},
                                             {"resident, MiB", "memory.resident_bytes", mebibyte, 2},
                                             {"ns per query", "time.separated_ns", 1, 0},
                                             {"ratio to baseline", "time.separated_ratio", 1, 3}};

const FigureColumn counter_columns[] = {
    {"minor faults", "counters.minor_faults"},
    {"major faults", "counters.major_faults"},
    {"context switches", "counters.context_switches"},
    {"migrations", "counters.cpu_migrations"},
    {"instructions", "counters.instructions"},
    {"cycles", "counters.cycles"},
    {"branch misses", "counters.branch_misses"},
    {"L1D fills", "counters.l1d_fills"},
    {"L2 demand misses", "counters.l2_demand_misses"},
    {"LLC misses", "counters.llc_misses"},
    {"dTLB walks", "counters.dtlb_walks"},
    {"table asked for, B", store::FigureName("heap.{structure}.requested_bytes").of("table")},
    {"size classes, B", store::FigureName("heap.{structure}.size_class_bytes").of("table")},
    {"slack, B", store::FigureName("heap.{structure}.slack_bytes").of("table")},
    {"resident, B", store::FigureName("heap.{structure}.resident_bytes").of("table")}};

double lines_of(const ReportCell& cell) {
    return cell.figure(store::lines_read.warm()).value.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

std::string reference_scene(const ReportData& data) {
    std::string first;
    for (const ReportCell* cell : data.swept()) {
        if (cell->scene == "tumble") return cell->scene_label;
        if (first.empty()) first = cell->scene_label;
    }
    return first;
}

TextGrid layout_cost_grid(const ReportData& data) {
    const std::string scene = reference_scene(data), shape = reference_shape(data);
    std::vector<const ReportCell*> cells = verified_cells(data, shape, scene);
    std::stable_sort(cells.begin(), cells.end(), [](const ReportCell* a, const ReportCell* b) {
        return std::make_tuple(b->algorithm, lines_of(*a)) < std::make_tuple(a->algorithm, lines_of(*b));
    });
    return cell_grid(fmt::format("{}, {}, fewest lines first", scene, shape), "algorithm|table type",
                     layout_cost_columns, cells);
}

TextGrid counters_grid(const ReportData& data) {
    const std::string shape = reference_shape(data);
    std::vector<const ReportCell*> cells = verified_cells(data, shape);
    const std::string scene = cells.empty() ? "" : cells.front()->scene_label;
    std::erase_if(cells, [&](const ReportCell* cell) { return cell->scene_label != scene; });
    // Columns that nothing was counted for are left out; the text above the table says why.
    std::vector<FigureColumn> shown;
    for (const FigureColumn& column : counter_columns) {
        const auto has = [&](const ReportCell* cell) {
            return cell->figure(column.figure).value.has_value();
        };
        if (std::any_of(cells.begin(), cells.end(), has)) shown.push_back(column);
    }
    return cell_grid(cells.empty() ? "" : scene + ", " + shape + ", per query", "algorithm|table type", shown,
                     cells);
}

TextGrid scene_memory_grid(const ReportData& data) {
    std::vector<const ReportCell*> cells = verified_cells(data);
    std::erase_if(
        cells, [](const ReportCell* cell) { return cell->figure("memory.tables").value.value_or(0) <= 4; });
    return cell_grid("Cells with more than four tables", cell_names, scene_memory_columns, cells);
}

TextGrid scale_grid(const ReportData& data) {
    TextGrid grid{
        "GJK over 64 instances of a body, each at a scale of its own: views of one table beside a table each",
        columns_of(
            "scene|shape|table type|#query, shared, ns|#tables of their own, ns|#shared / own|"
            "#bytes, shared|#bytes, own|#own / shared|#to build one, ns|#to refit it, ns|#worst error")};
    for (const ReportCell& cell : data.cells) {
        const measure::Figure shared = cell.figure("scale.shared_query_ns");
        if (!cell.verified() || !shared.value) continue;
        const measure::Figure shared_bytes = cell.figure("scale.shared_bytes"),
                              own_bytes = cell.figure("scale.own_bytes");
        grid.add(cell.scene_label, cell.shape, cell.table, shared, cell.figure("scale.own_query_ns"),
                 interval_cell(cell.figure("scale.shared_over_own"), cell.figure("scale.shared_over_own_low"),
                               cell.figure("scale.shared_over_own_high"), 2),
                 shared_bytes, own_bytes, ratio_cell(own_bytes, shared_bytes), cell.figure("scale.build_ns"),
                 cell.figure("scale.refit_ns"), cell.figure("scale.worst_error"));
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
