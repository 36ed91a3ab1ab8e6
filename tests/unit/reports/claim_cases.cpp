// SPDX-License-Identifier: MIT
#include "claim_cases.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace edgewise::reports {

ReportCell make_cell(const MadeCell& made, const MadeFigures& figures) {
    ReportCell cell;
    cell.scene = made.scene;
    cell.shape = made.shape;
    const auto digit = made.shape.find_first_of("0123456789");
    cell.vertices = digit == std::string::npos ? 0 : std::stoi(made.shape.substr(digit));
    cell.algorithm = made.algorithm;
    cell.table = made.table;
    cell.status = store::CellStatus::verified;
    cell.scene_parameters =
        made.parameter.empty() ? "{}" : fmt::format(R"({{"{}":{}}})", made.parameter, made.x);
    for (const auto& [name, value] : figures) {
        const auto dot = name.find('.');
        cell.figures.push_back({{name.substr(dot + 1), value, ""}, name.substr(0, dot)});
    }
    return cell;
}

MadeFigures made_time(double ns) {
    return {{"time.all_ns", ns}, {"time.all_ns_low", 0.98 * ns}, {"time.all_ns_high", 1.02 * ns}};
}

std::string made_shape(int vertices) {
    if (vertices == 4) return "tetra4";
    return vertices == 8 ? "cube8" : "sphere" + std::to_string(vertices);
}

void add_angular(ReportData& data, int vertices, const std::string& algorithm,
                 const std::function<MadeFigures(int)>& figures) {
    const std::string scene = fmt::format("paper_angular_{}", vertices);
    int number = 0;
    for (const double step : made_steps)
        add_cell(data, {scene, made_shape(vertices), algorithm, "rotation_step", step}, figures(number++));
}

void add_angular_time(ReportData& data, int vertices, const std::string& algorithm, double ns) {
    add_angular(data, vertices, algorithm, [ns](int) { return made_time(ns); });
}

}  // namespace edgewise::reports
