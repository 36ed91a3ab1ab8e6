// SPDX-License-Identifier: MIT
#include "edgewise/sweep/work.hpp"

#include <algorithm>
#include <stdexcept>

#include "edgewise/scene/scenes.hpp"

namespace edgewise {

std::size_t SweepWork::cells_of_group() const {
    std::size_t count = 0;
    for (const TableType* type : types) {
        count += static_cast<std::size_t>(std::count_if(
            algorithms.begin(), algorithms.end(), [&](const auto& name) { return type->serves(name); }));
    }
    return count;
}

SweepWork prepare_sweep(const Plan& plan, const std::function<void(const std::string& line)>& warn) {
    SweepWork work;
    work.plan = plan;
    work.types = select_table_types(plan.layouts);
    work.algorithms = select_algorithms(plan.algorithms);
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
