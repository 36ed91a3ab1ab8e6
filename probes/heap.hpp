// SPDX-License-Identifier: MIT
//
// Heap: what one table, the caches of all pairs and the broad phase's arrays take in jemalloc, each in an
// arena of its own. Slack is what size classes add to what was asked for.
#pragma once

#include "edgewise/bench/probe.hpp"

namespace edgewise::probes {

struct heap {
    static constexpr std::string_view summary =
        "one table, pair caches, broad phase in jemalloc: requested, size classes, slack, resident";

    /// Heap use of one newly built table of the first body, and of blocks with the sizes of the pairs' caches
    /// and of the broad phase's arrays.
    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell);
};

}  // namespace edgewise::probes
