// SPDX-License-Identifier: MIT
#include "edgewise/sweep/work.hpp"

#include <algorithm>
#include <stdexcept>

#include "edgewise/scene/scenes.hpp"

namespace edgewise {

std::size_t SweepWork::cells_of_group() const {
    std::size_t count = 0;
    each_cell([&](const TableType&, const std::string&, const Axes&) { ++count; });
    return count;
}

void SweepWork::each_cell(
    const std::function<void(const TableType&, const std::string& algorithm, const Axes&)>& use) const {
    for (const TableType* type : types) {
        for (const std::string& algorithm : algorithms) {
            if (!type->serves(algorithm)) continue;
            for (const Axes& chosen : axes) {
                if (chosen.text().empty() || chosen.concerns(algorithm)) use(*type, algorithm, chosen);
            }
        }
    }
}

SweepWork prepare_sweep(const Plan& plan, const std::function<void(const std::string& line)>& warn) {
    SweepWork work;
    work.plan = plan;
    work.types = select_table_types(plan.layouts);
    work.algorithms = select_algorithms(plan.algorithms);
    work.axes.emplace_back();
    for (const std::string& text : plan.axes) work.axes.push_back(parse_axes(text));
    for (SceneChoice& scene : work.plan.scenes) {
        auto complete = complete_parameters(scene.name, scene.parameters);
        if (!complete) throw std::invalid_argument(complete.error);
        scene.parameters = std::move(*complete);
    }
    work.shapes = shapes_of(plan, warn);
    if (work.cells() == 0) {
        throw std::invalid_argument(
            "this plan has no cells: no layout serves the algorithms chosen, or no shape or scene is left");
    }
    return work;
}

}  // namespace edgewise
