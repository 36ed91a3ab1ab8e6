// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/counter_arithmetic.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "edgewise/measure/statistics.hpp"

namespace edgewise::measure {

namespace {

/// By nearest rank, so that it is a count that did occur.
std::uint64_t rank(std::vector<std::uint64_t>& counts, std::size_t numerator, std::size_t denominator) {
    const std::size_t index = (counts.size() - 1) * numerator / denominator;
    std::nth_element(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(index), counts.end());
    return counts[index];
}

struct Sorted {
    std::vector<double> good;
    std::size_t faulted = 0, switched = 0, migrated = 0, shared = 0;  ///< a sample may be in several
};

Sorted sort_out(std::span<const CounterSample> samples) {
    Sorted sorted;
    for (const CounterSample& sample : samples) {
        sorted.faulted += sample.page_faults != 0 ? 1 : 0;
        sorted.switched += sample.context_switches != 0 ? 1 : 0;
        sorted.migrated += sample.migrations != 0 ? 1 : 0;
        sorted.shared += sample.shared_its_counter() ? 1 : 0;
        if (sample.is_disturbed() || sample.shared_its_counter()) continue;
        sorted.good.push_back(static_cast<double>(sample.count));
    }
    return sorted;
}

std::string why_dropped(const Sorted& sorted, std::size_t total) {
    return fmt::format(
        "of {} samples only {} are good: {} had page faults, {} context switches, {} a change of the "
        "processor, {} shared their counter",
        total, sorted.good.size(), sorted.faulted, sorted.switched, sorted.migrated, sorted.shared);
}

}  // namespace

Expected<CountingCost> counting_cost(std::span<const std::uint64_t> empty_batches) {
    if (empty_batches.size() < least_empty_batches)
        return Refusal{
            fmt::format("{} empty batches say too little of what counting costs", empty_batches.size()),
            fmt::format("count at least {}", least_empty_batches)};
    std::vector<std::uint64_t> counts(empty_batches.begin(), empty_batches.end());
    const std::uint64_t overhead = rank(counts, 1, 2);
    return {CountingCost{overhead, std::max<std::uint64_t>(rank(counts, 9, 10), 1)}};
}

Expected<CounterFigure> count_per_query(std::span<const CounterSample> samples, const CountingCost& cost,
                                        std::size_t queries) {
    if (queries == 0) return Refusal{"no queries in the batch", "count a batch that has some"};
    const Sorted sorted = sort_out(samples);
    if (sorted.good.size() < least_samples)
        return Refusal{why_dropped(sorted, samples.size()),
                       "leave the machine to this program, pin it to a processor, and count more often or in "
                       "shorter batches"};
    const double batch = median(sorted.good).value_or(0) - static_cast<double>(cost.overhead);
    const double least = static_cast<double>(least_to_floor * cost.floor);
    if (batch < least)
        return Refusal{
            fmt::format("fewer than {} in a batch of {} queries, so below {:.3g} per query: too few to tell "
                        "from what counting itself may cause ({})",
                        least, queries, least / static_cast<double>(queries), cost.floor),
            "count a batch of more queries"};
    return {CounterFigure{batch / static_cast<double>(queries), sorted.good.size(),
                          samples.size() - sorted.good.size()}};
}

}  // namespace edgewise::measure
