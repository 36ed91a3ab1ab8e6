// SPDX-License-Identifier: MIT
//
// The paper's cost functions, equations 1 and 2: T = N_v C_v + N_p C_p (+ N_u C_u), each term as measured,
// and their sums beside the measured step.
#include "edgewise/reports/paper/chapter/paper_tables.hpp"
#include "edgewise/reports/tables/formatting.hpp"

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

}  // namespace

TextGrid cost_grid(const ReportData& data, bool of_bodies) {
    TextGrid grid = figure_grid("Cost functions per step, on the baseline's table type (aos_f64)",
                                "scene|varies|#at|algorithm", cost_columns);
    grid.columns.push_back({"equation 2 / measured", true});
    for (const StoredScene& scene : scene_files(data)) {
        if (scene.name.starts_with("paper_bodies") != of_bodies) continue;
        for (const ReportCell* cell : scene.cells)
            if (cell->verified() && cell->table == "aos_f64" && has_cost(*cell))
                add_cost_row(grid, scene, *cell);
    }
    return grid;
}

}  // namespace edgewise::reports
