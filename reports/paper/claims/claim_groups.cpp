// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/claims/claim_groups.hpp"

#include <fmt/core.h>

namespace edgewise::reports {

namespace {

std::string angular_scene(int vertices) { return fmt::format("paper_angular_{}", vertices); }

Evidence no_slow_cell(int vertices, const std::string& algorithm) {
    return no_evidence(fmt::format("no cell of scene {}, {} on aos_f64, with a speed above 0 is stored",
                                   angular_scene(vertices), algorithm));
}

}  // namespace

std::string paper_shape(int vertices) {
    return vertices == 4 ? "tetra4" : vertices == 8 ? "cube8" : "sphere" + std::to_string(vertices);
}

std::vector<CurveCell> angular_cells(const ReportData& data, int vertices, const std::string& algorithm,
                                     const CurveRange& steps) {
    return in_range(cells_along(data, {angular_scene(vertices), "", algorithm}, "rotation_step"), steps);
}

std::string no_angular_cells(int vertices) {
    return fmt::format("no cells of scene {} with speeds in the range are stored", angular_scene(vertices));
}

const ReportCell* slowest_cell(const ReportData& data, int vertices, const std::string& algorithm) {
    for (const CurveCell& at : cells_along(data, {angular_scene(vertices), "", algorithm}, "rotation_step"))
        if (at.x > 0) return at.cell;
    return nullptr;
}

Evidence slowest_figure(const ReportData& data, int vertices, const std::string& algorithm,
                        const store::FigureName& name) {
    const ReportCell* cell = slowest_cell(data, vertices, algorithm);
    return cell ? figure_of(*cell, name) : no_slow_cell(vertices, algorithm);
}

Evidence slowest_time(const ReportData& data, int vertices, const std::string& algorithm) {
    const ReportCell* cell = slowest_cell(data, vertices, algorithm);
    return cell ? time_of(*cell) : no_slow_cell(vertices, algorithm);
}

}  // namespace edgewise::reports
