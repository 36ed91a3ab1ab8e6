// SPDX-License-Identifier: MIT
//
// Tables of costs. The paper's cost functions, equations 1 and 2: T = N_v C_v + N_p C_p (+ N_u C_u), each
// term as measured, and their sums next to the measured step. The cost of each need: times with the axis
// `needs` over the plain cell's, which gives witness points; and its reads, nearness next to the other needs,
// over all pairs, since a verdict on nearness does not show which pairs are in contact. Ease of
// implementation: the cost of building the tables.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string_view>
#include <tuple>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

const FigureColumn cost_columns[] = {{"N_v box tests", "cost.box_tests_per_step"},
                                     {"C_v, ns", "cost.box_test_ns"},
                                     {"N_p pairs", "cost.pairs_per_step"},
                                     {"C_p, ns", "cost.pair_ns"},
                                     {"N_u boxes", "cost.bodies"},
                                     {"C_u, ns", "cost.update_ns"},
                                     {"equation 1, ns", "cost.equation_1_ns"},
                                     {"equation 2, ns", "cost.equation_2_ns"},
                                     {"measured, ns", "cost.step_ns"}};

bool has_cost(const ReportCell& cell) {
    for (const store::FigureRow& figure : cell.figures)
        if (figure.probe == "cost" && figure.value) return true;
    return false;
}

void add_cost_row(TextGrid& grid, const StoredScene& scene, const ReportCell& cell) {
    const auto place = scene.place(cell);
    add_row(grid,
            grid_row(scene.name, scene.varied.empty() ? cell.shape : scene.axis_title(),
                     place ? number_text(*place) : "–", cell.algorithm),
            cell, cost_columns);
    grid.rows.back().push_back(ratio_cell(cell.figure("cost.equation_2_ns"), cell.figure("cost.step_ns")));
}

constexpr const char* needs[] = {"verdict", "distance", "features", "depth", "certificate"};
constexpr std::string_view margin_mark = ", margin ";

/// Axes -> cell, of one shape, algorithm, layout and precision.
using ByAxes = std::map<std::string, const ReportCell*>;
using Groups = std::map<std::tuple<std::int64_t, std::string, std::string, std::string>, ByAxes>;

Groups groups_of(const StoredScene& scene) {
    Groups groups;
    for (const ReportCell* cell : scene.cells)
        groups[{cell->vertices, cell->shape, cell->algorithm, cell->layout + "_" + cell->precision}]
              [cell->axes] = cell;
    return groups;
}

GridCell needs_ratio_of(const ByAxes& cells, const std::string& need, const store::FigureName& time) {
    const auto cell = cells.find("needs=" + need), plain = cells.find("");
    if (cell == cells.end()) return missing_cell("the store has no cell with needs=" + need);
    const measure::Figure ns = cell->second->figure(time);
    if (!ns.value) return figure_cell(ns);
    if (plain == cells.end()) return missing_cell("the store has no plain cell to compare with");
    return ratio_cell(ns, plain->second->figure(time));
}

/// How a need is named for people: "nearer, margin 0.1".
std::string need_name(const ReportCell& cell) {
    const auto need = cell.axis("needs"), margin = cell.axis("margin");
    if (!need) return "witnesses";
    return margin ? *need + std::string(margin_mark) + *margin : *need;
}

/// Least asked first: nearness by its margins, witnesses behind the distance.
std::vector<const ReportCell*> by_need(const ByAxes& cells) {
    // As in table/needs.hpp, which a report does not see.
    constexpr std::array<std::string_view, 7> order = {"nearer",   "verdict", "distance",   "witnesses",
                                                       "features", "depth",   "certificate"};
    const auto place = [&](const ReportCell* cell) {
        const std::string name = need_name(*cell);
        const std::size_t mark = name.find(margin_mark);
        const std::string margin = mark == name.npos ? "0" : name.substr(mark + margin_mark.size());
        return std::tuple(std::ranges::find(order, name.substr(0, mark)) - order.begin(),
                          std::strtod(margin.c_str(), nullptr), cell->axes);
    };
    std::vector<const ReportCell*> sorted;
    for (const auto& [axes, cell] : cells) sorted.push_back(cell);
    std::ranges::sort(sorted, [&](const ReportCell* a, const ReportCell* b) { return place(a) < place(b); });
    return sorted;
}

}  // namespace

TextGrid cost_grid(const ReportData& data, bool of_bodies) {
    TextGrid grid = figure_grid("Cost functions per step, on the baseline's table type (aos_f64)",
                                "scene|varies|#at|algorithm", cost_columns);
    grid.columns.push_back({"equation 2 / measured", true});
    for (const StoredScene& scene : scene_files(data)) {
        if ((scene.name == "paper_bodies" || scene.name == "paper_bodies_shrinking") != of_bodies) continue;
        for (const ReportCell* cell : scene.cells)
            if (cell->verified() && cell->table == "aos_f64" && has_cost(*cell))
                add_cost_row(grid, scene, *cell);
    }
    return grid;
}

TextGrid needs_grid(const ReportData& data) {
    TextGrid grid{"Cost of each need: time divided by the time for witness points, plain cell",
                  columns_of("shape|algorithm|table type|pairs|#witnesses, ns")};
    for (const char* need : needs) grid.columns.push_back({need, true});
    for (const auto& [key, cells] : groups_of(scene_file(data, "paper_needs"))) {
        const auto& [vertices, shape, algorithm, table] = key;
        const auto plain = cells.find("");
        for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
            const store::FigureName& time = times_of(kind).ns;
            std::vector<GridCell> row = grid_row(shape, algorithm, table, pair_name(kind));
            row.push_back(plain == cells.end() ? missing_cell("the store has no plain cell")
                                               : figure_cell(plain->second->figure(time)));
            for (const char* need : needs) row.push_back(needs_ratio_of(cells, need, time));
            grid.rows.push_back(std::move(row));
        }
    }
    return grid;
}

TextGrid all_needs_grid(const ReportData& data) {
    TextGrid grid{
        "Cost of each need over all pairs, and cache lines that a query reads of the tables; warm queries "
        "for nearness try the bounds first",
        columns_of("shape|algorithm|table type|need|#ns per query|#over witnesses|#lines per warm query|"
                   "#told by bounds")};
    for (const auto& [key, cells] : groups_of(scene_file(data, "paper_needs"))) {
        const auto& [vertices, shape, algorithm, table] = key;
        const auto plain = cells.find("");
        for (const ReportCell* cell : by_need(cells)) {
            const measure::Figure ns = cell->figure("time.all_ns");
            grid.add(shape, algorithm, table, need_name(*cell), ns,
                     plain == cells.end() ? missing_cell("the store has no plain cell to compare with")
                                          : ratio_cell(ns, plain->second->figure("time.all_ns")),
                     cell->figure(store::lines_read.warm()),
                     figure_cell(cell->figure("work.told_by_bounds"), 1, 3));
        }
    }
    return grid;
}

TextGrid build_grid(const ReportData& data) {
    const FigureColumn columns[] = {{"build, ns", "build.build_ns"},
                                    {"refit, ns", "build.refit_ns"},
                                    {"bytes per edge (slope)", "bytes.paper_bytes_per_edge"},
                                    {"table, bytes", "bytes.table_bytes"}};
    std::vector<const ReportCell*> cells = scene_file(data, "paper_complexity").cells;
    std::erase_if(cells, [](const ReportCell* cell) { return !cell->axes.empty(); });
    return cell_grid(
        "Preprocessing: building a table, and refitting it to a deformed body of the same topology",
        "shape|#vertices|algorithm|table type", columns, cells);
}

}  // namespace edgewise::reports
