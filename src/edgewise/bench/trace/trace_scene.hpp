// SPDX-License-Identifier: MIT
//
// A cell's traced passes: two over the same queries, through every chosen machine at once.
#pragma once

#include "edgewise/bench/probe.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"

namespace edgewise::bench {

/// Trace of a runner with the workload loaded. The last known machine except `host` is modelled under the
/// other replacement policies too.
[[nodiscard]] measure::SceneTrace trace_scene(const Runner& runner, const scene::Workload& workload,
                                              const CacheOrder& order);

/// The cell's, made once for all probes that use it.
[[nodiscard]] const measure::SceneTrace& scene_trace(const ProbedCell& cell);

}  // namespace edgewise::bench
