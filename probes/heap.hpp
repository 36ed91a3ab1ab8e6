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

    /// One table of the first body, built anew; and blocks of the sizes that the caches of a scene's pairs
    /// and the arrays of its broad phase have.
    [[nodiscard]] static bench::Findings measure(const bench::ProbedCell& cell);
};

}  // namespace edgewise::probes
