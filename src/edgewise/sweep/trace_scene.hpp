// SPDX-License-Identifier: MIT
//
// A cell's traced passes: two over the same queries, through every chosen machine at once.
#pragma once

#include <span>

#include "edgewise/bench/runner.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/cache/scene_trace.hpp"

namespace edgewise::sweep {

/// A number that is another one for other machines or another number of queries; whole, and exact as a
/// figure.
[[nodiscard]] double trace_identity(std::span<const measure::MachineChoice> machines, std::size_t queries);

/// Of a runner whose tables are loaded for the workload; of that so many queries that count, 0: all. The last
/// known machine but `host` is modelled under the other replacement policies too.
[[nodiscard]] measure::SceneTrace trace_scene(const bench::Runner& runner, const scene::Workload& workload,
                                              std::size_t queries,
                                              std::span<const measure::MachineChoice> machines);

}  // namespace edgewise::sweep
