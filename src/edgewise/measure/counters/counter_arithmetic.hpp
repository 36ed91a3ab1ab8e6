// SPDX-License-Identifier: MIT
//
// Computes a figure per query from counts of batches of queries. Pure functions, so that they are tested
// without counters. The cost of counting is measured by empty batches and subtracted. A count too small to be
// distinguished from it is refused, as is one that was disturbed or shared its counter. Nothing is scaled, no
// 0 is made up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

/// One batch: what an event counted, and what else happened meanwhile.
struct CounterSample {
    std::uint64_t count = 0;
    std::uint64_t enabled_ns = 0, running_ns = 0;  ///< asked for, and on a counter
    std::uint64_t page_faults = 0, context_switches = 0, migrations = 0;

    [[nodiscard]] bool is_disturbed() const { return page_faults + context_switches + migrations != 0; }
    [[nodiscard]] bool shared_its_counter() const { return running_ns < enabled_ns; }
};

/// Count of an event when nothing is done between start and stop.
struct CountingCost {
    std::uint64_t overhead = 0;  ///< the median
    std::uint64_t floor = 1;  ///< what a batch may count by itself: nine in ten stay at or below; at least 1
};

inline constexpr std::size_t least_empty_batches = 100;
inline constexpr std::size_t least_samples = 3;  ///< undisturbed ones: of fewer, one outlier is the median
inline constexpr std::uint64_t least_to_floor = 10;  ///< least batch count, in multiples of the floor

/// Refused for fewer than least_empty_batches.
[[nodiscard]] Expected<CountingCost> counting_cost(std::span<const std::uint64_t> empty_batches);

struct CounterFigure {
    double per_query = 0;
    std::size_t samples = 0;  ///< used
    std::size_t dropped = 0;  ///< disturbed, or shared their counter
};

/// The median of the samples that are good, less the overhead, over the queries of one batch.
[[nodiscard]] Expected<CounterFigure> count_per_query(std::span<const CounterSample> samples,
                                                      const CountingCost& cost, std::size_t queries);

}  // namespace edgewise::measure
