// SPDX-License-Identifier: MIT
//
// What a plan comes to in this program: its names looked up, its bodies made. All that can be wrong with a
// plan is wrong here, before a store is opened.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/sweep/registry.hpp"
#include "edgewise/sweep/shapes_of.hpp"

namespace edgewise {

struct SweepWork {
    Plan plan;  ///< with every scene parameter
    std::vector<const TableType*> types;
    std::vector<std::string> algorithms;
    std::vector<Axes> axes;  ///< the plain cell first
    std::vector<NamedShape> shapes;

    /// The cells of one scene and shape, each once.
    void each_cell(
        const std::function<void(const TableType&, const std::string& algorithm, const Axes&)>& use) const;
    /// How many they are.
    [[nodiscard]] std::size_t cells_of_group() const;
    [[nodiscard]] std::size_t cells() const { return cells_of_group() * shapes.size() * plan.scenes.size(); }
};

/// Throws std::invalid_argument: what, where, what to do. `warn` hears of what is only a pity.
[[nodiscard]] SweepWork prepare_sweep(const Plan& plan,
                                      const std::function<void(const std::string& line)>& warn);

}  // namespace edgewise
