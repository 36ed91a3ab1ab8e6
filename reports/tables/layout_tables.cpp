// SPDX-License-Identifier: MIT
//
// Costs of layouts: their bytes; in one scene with one shape (results/ has all) cache lines that queries
// touch, time to build and to refit, and counted figures. Also the gain from tables of seeds, and support
// queries on one line per vertex compared with support queries on separate arrays.

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

const FigureColumn total_columns[] = {{"total", "bytes.total_bytes_per_edge"},
                                      {"paper's subtotal (slope)", "bytes.paper_bytes_per_edge"},
                                      {"total (slope)", "bytes.slope_bytes_per_edge"},
                                      {"table, bytes", "bytes.table_bytes"}};

/// Largest first; those without a total last.
double sort_total(const ReportCell& cell) {
    return cell.figure("bytes.total_bytes_per_edge").value.value_or(-1);
}

}  // namespace

std::string reference_shape(const ReportData& data) {
    const ReportCell* largest = nullptr;
    for (const ReportCell* cell : data.swept()) {
        if (cell->shape == "sphere386") return cell->shape;
        if (!largest || std::tie(cell->vertices, largest->shape) > std::tie(largest->vertices, cell->shape))
            largest = cell;
    }
    return largest ? largest->shape : "";
}

std::vector<std::string> byte_components(const ReportData& data) {
    std::vector<std::string> order{"voronoi_planes", "edge_geometry", "vertex_coordinates",
                                   "face_planes",    "topology",      "input_order",
                                   "padding"};
    std::set<std::string> present;
    for (const ReportCell* cell : data.swept())
        for (const store::FigureRow& figure : cell->figures)
            if (figure.probe == "bytes" && figure.unit == "B/edge" &&
                !figure.name.ends_with("_bytes_per_edge"))
                present.insert(figure.name);
    std::erase_if(order, [&](const std::string& name) { return present.erase(name) == 0; });
    order.insert(order.end(), present.begin(), present.end());
    return order;
}

TextGrid bytes_grid(const ReportData& data, const std::string& shape) {
    const std::vector<std::string> components = byte_components(data);
    const bool all_shapes = shape.empty();
    std::string names = all_shapes ? "shape|#edges|algorithm|table type" : "algorithm|table type";
    for (const std::string& name : components) names += "|#" + in_words(name);
    TextGrid grid =
        figure_grid("Bytes per edge of the built tables" + (all_shapes ? std::string() : ", " + shape), names,
                    total_columns);
    std::vector<const ReportCell*> cells = verified_cells(data, shape);
    std::ranges::stable_sort(cells, [](const ReportCell* a, const ReportCell* b) {
        const double total_a = sort_total(*a), total_b = sort_total(*b);
        return std::tie(b->vertices, a->shape, b->algorithm, total_b, a->table) <
               std::tie(a->vertices, b->shape, a->algorithm, total_a, b->table);
    });
    std::set<std::vector<GridCell>> seen;
    for (const ReportCell* cell : cells) {
        std::vector<GridCell> row = grid_row(cell->algorithm, cell->table);
        if (all_shapes) row = grid_row(cell->shape, cell->edges, cell->algorithm, cell->table);
        for (const std::string& name : components) row.push_back(figure_cell(cell->figure("bytes", name)));
        add_row(grid, std::move(row), *cell, total_columns);
        if (!seen.insert(grid.rows.back()).second) grid.rows.pop_back();
    }
    return grid;
}

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
                                             {"asked for, MiB", "memory.requested_bytes", mebibyte},
                                             {"taken, MiB", "memory.taken_bytes", mebibyte},
                                             {"resident, MiB", "memory.resident_bytes", mebibyte},
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
    std::ranges::stable_sort(cells, [](const ReportCell* a, const ReportCell* b) {
        return std::make_tuple(b->algorithm, or_infinity(*a, store::lines_read.warm())) <
               std::make_tuple(a->algorithm, or_infinity(*b, store::lines_read.warm()));
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
        if (std::ranges::any_of(cells, has)) shown.push_back(column);
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
        "GJK over 64 instances of a body, each at a scale of its own: views of one table, and a table each",
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

namespace {

constexpr store::FigureName table_bytes("bytes.table_bytes");

const FigureColumn seed_columns[] = {{"ns per query", "time.all_ns", 1, 0},
                                     {"steps", store::mean_steps.all, 1, 2},
                                     {"lines", store::lines_read.all, 1, 1}};

/// How the scene's queries start, if all of them start far from their answers; else nothing.
std::string far_start(const ReportCell& cell) {
    if (cell.scene == "cold") return "cold";
    const bool random = cell.scene == "tumble" && parameter_of(cell, "random_orientation").value_or(0) != 0;
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
    std::ranges::sort(all, [&](const SeededCell& a, const SeededCell& b) { return place(a) < place(b); });
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

namespace {

constexpr double claimed = 5;
constexpr store::FigureName query_ns("support.query_ns.{start}");

/// A scene, shape, precision and start on both layouts.
struct Compared {
    const ReportCell *line, *separate;
    std::string start;
    measure::Figure line_ns, separate_ns;

    [[nodiscard]] bool known() const { return line_ns.value && separate_ns.value && *line_ns.value > 0; }
    [[nodiscard]] double faster() const { return *separate_ns.value / *line_ns.value; }
};

/// Plain cells alone: their table is the type's name.
bool is_plain(const ReportCell& cell, const char* layout) {
    return cell.verified() && cell.algorithm == "gjk" && cell.layout == layout &&
           cell.table == cell.layout + "_" + cell.precision;
}

std::vector<Compared> compared(const ReportData& data) {
    std::vector<Compared> all;
    const std::vector<const ReportCell*> cells = data.swept();
    for (const ReportCell* line : cells) {
        if (!is_plain(*line, "line_per_vertex")) continue;
        const auto same = [&](const ReportCell* other) {
            return is_plain(*other, "aos") && other->scene_label == line->scene_label &&
                   other->shape == line->shape && other->precision == line->precision;
        };
        const auto separate = std::ranges::find_if(cells, same);
        if (separate == cells.end()) continue;
        for (const std::string start : {"cold", "warm"}) {
            const store::FigureName name = query_ns.of(start);
            all.push_back({line, *separate, start, line->figure(name), (*separate)->figure(name)});
        }
    }
    return all;
}

}  // namespace

TextGrid support_grid(const ReportData& data) {
    TextGrid grid{
        "Support queries, ns",
        columns_of("scene|shape|precision|start|#separate arrays|#line per vertex|#separate / line")};
    for (const Compared& row : compared(data))
        grid.add(row.line->scene_label, row.line->shape, row.line->precision, row.start, row.separate_ns,
                 row.line_ns, ratio_cell(row.separate_ns, row.line_ns));
    return grid;
}

std::string support_verdict(const ReportData& data) {
    std::vector<Compared> all = compared(data);
    std::erase_if(all, [](const Compared& row) { return !row.known(); });
    if (all.empty())
        return " Verdict: not measured; `edgewise sweep --layouts aos,line_per_vertex` measures it.";
    const auto slower = [](const Compared& a, const Compared& b) { return a.faster() < b.faster(); };
    const Compared& best = *std::ranges::max_element(all, slower);
    const auto below = std::ranges::count_if(all, [](const Compared& row) { return row.faster() < 1; });
    return fmt::format(
        " Verdict: {}; at most {:.2f} times as fast ({}, {}, {}, {} start), and slower in {} of {} comparisons.",
        best.faster() >= claimed ? "held" : "not held", best.faster(), best.line->scene_label,
        best.line->shape, best.line->precision, best.start, below, all.size());
}

}  // namespace edgewise::reports
