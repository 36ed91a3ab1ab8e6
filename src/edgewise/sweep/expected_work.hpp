// SPDX-License-Identifier: MIT
//
// How much work the groups of a sweep are, so that what is left can be estimated (time_left.hpp) and shards
// be made even. A group is a scene on a shape with all its cells. Work is in seconds: the time that the same
// group took when it last ran into the store, else rules of thumb, whose ratios alone matter.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

/// What a group does in turn.
enum class Step {
    verify,  ///< tables built, every query answered, a sample checked exactly
    trace,   ///< caches modelled, on all processors
    rounds,  ///< timed
    alone    ///< counters, lines, and what else is measured cell by cell
};

inline constexpr Step steps[] = {Step::verify, Step::trace, Step::rounds, Step::alone};

struct GroupWork {
    std::array<double, 4> parts{};  ///< by Step
    bool remembered = false;        ///< an earlier run measured their sum
    bool own_tables = false;        ///< every body has one: queries wait for memory

    [[nodiscard]] double of(Step step) const { return parts[static_cast<std::size_t>(step)]; }
    [[nodiscard]] double all() const { return parts[0] + parts[1] + parts[2] + parts[3]; }
    /// Kind of work for TimeLeft.
    [[nodiscard]] std::string kind(Step step) const;
};

/// Number of cells of a group, and of its cells on tables of points alone, most of which queries read
/// completely.
struct CellCount {
    std::size_t all = 0, points = 0;
};
[[nodiscard]] CellCount count_cells(const SweepWork& work, const SceneWork& scene);

/// Work of a group by rules of thumb: queries by the root of the body's vertices, tables by its vertices.
/// A body that is missing has no work. `processors` share the traces.
[[nodiscard]] GroupWork estimated_work(const Plan& plan, const SceneWork& scene,
                                       const scene::NamedShape& shape, const CellCount& cells,
                                       unsigned processors = std::thread::hardware_concurrency());

/// Names a group in a store: scene, parameters, shape, queries, rounds, and how many cells.
[[nodiscard]] std::string group_key(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape,
                                    std::size_t cells);

/// Work of all groups, in the order in which they run. `took_before`: seconds by a group's key.
[[nodiscard]] std::vector<GroupWork> expected_work(
    const SweepWork& work, const std::function<std::optional<double>(const std::string& key)>& took_before);

}  // namespace edgewise::sweep
