// SPDX-License-Identifier: MIT
//
// How much of a workload a trace follows, from its beginning. In queries; in whole steps of a scene in time
// order, since its first step is all cold and some queries of the next few are no steady state; and, where
// those would be too many, of every k-th pair alone, which is followed through all of them. A pair knows
// nothing of the others, so what its queries read is the same; what caches hold is not: those that model
// caches follow every pair.
#pragma once

#include <cstddef>
#include <limits>

#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

struct TraceExtent {
    std::size_t
        counted;  ///< ends after this many counted queries (those that start warm where pairs are followed)
    std::size_t steps = 0;        ///< nor before this number of whole steps, where the scene has that many
    std::size_t pair_stride = 1;  ///< follows one of this number of pairs, by their slots

    // NOLINTNEXTLINE(google-explicit-constructor): a number of queries is an extent.
    TraceExtent(std::size_t queries, std::size_t whole_steps = 0, std::size_t stride = 1)
        : counted(queries), steps(whole_steps), pair_stride(stride) {}

    [[nodiscard]] static TraceExtent everything() { return {std::numeric_limits<std::size_t>::max()}; }

    /// Queries before this one are within the steps.
    [[nodiscard]] std::size_t end_of_steps(const scene::Workload& workload) const {
        if (steps == 0 || workload.frames.empty()) return 0;
        return steps < workload.frames.size() ? workload.frames[steps].first_query : workload.queries.size();
    }
};

/// Steps that a trace of a scene in time order takes at least.
inline constexpr std::size_t least_traced_steps = 50;

/// An extent of about `queries` queries, from the least number of steps or more, with the pairs that fit.
[[nodiscard]] inline TraceExtent sampled_extent(const scene::Workload& workload, std::size_t queries) {
    TraceExtent extent(queries, least_traced_steps);
    const std::size_t within = extent.end_of_steps(workload);
    if (within > queries) extent.pair_stride = within / queries;
    return extent;
}

}  // namespace edgewise::bench
