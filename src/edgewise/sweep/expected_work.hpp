// SPDX-License-Identifier: MIT
//
// What the groups of a sweep are expected to take, so that its progress is one of time: a group is a scene on
// a shape with all its cells. From the seconds that the same group took when it last ran into the store, else
// from a model of the work; only ratios between groups count.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

/// By what a group does in turn; seconds on some machine.
struct GroupWork {
    double verify = 0;  ///< tables built, every query answered, a sample checked exactly
    double beside = 0;  ///< caches modelled, on all processors
    double rounds = 0;  ///< timed
    double alone = 0;   ///< counters, lines, and what else is measured cell by cell

    [[nodiscard]] double all() const { return verify + beside + rounds + alone; }
};

/// Of a group of this many cells, by the model; nothing of a body that there is not. What is beside others is
/// shared by so many processors.
[[nodiscard]] GroupWork modelled_work(const Plan& plan, const SceneWork& scene,
                                      const scene::NamedShape& shape, std::size_t cells,
                                      unsigned processors = std::thread::hardware_concurrency());

/// Names a group in a store: scene, parameters, shape, queries, rounds, and how many cells.
[[nodiscard]] std::string group_key(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                                    std::size_t cells);

/// For all groups, in the order in which they run. `remembered`: seconds by a group's key. Of groups that are
/// not remembered the model, in the proportion in which it misses those that are.
[[nodiscard]] std::vector<GroupWork> expected_work(
    const SweepWork& work, const std::function<std::optional<double>(const std::string& key)>& remembered);

}  // namespace edgewise::sweep
