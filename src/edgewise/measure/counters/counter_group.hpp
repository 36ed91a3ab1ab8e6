// SPDX-License-Identifier: MIT
//
// Events that the Linux kernel counts together for the calling thread, over exactly the same instructions, so
// that their ratios are valid (man 2 perf_event_open). The group is pinned: it is on the counters the whole
// time or in error, and never shares them. A count that was on a counter only part of the time is refused;
// scaling it up would be a guess.
//
// And the figure per query of counts of batches of queries, in pure functions. The cost of counting is
// measured by empty batches and subtracted. A count is refused if it is too small to be distinguished from
// that cost, if it was disturbed, or if it shared its counter. Nothing is scaled, and a missing count never
// becomes 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "edgewise/measure/counters/events.hpp"
#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

/// Some processors have four counters per thread for any event, and the watchdog may hold one.
inline constexpr std::size_t largest_group = 4;

struct GroupCount {
    std::array<std::uint64_t, largest_group> values{};  ///< in the order of the events
    std::uint64_t enabled_ns = 0, running_ns = 0;       ///< equal: else the count is refused
};

class CounterGroup {
  public:
    /// One to largest_group events; the first leads.
    explicit CounterGroup(std::span<const EventCode> events);
    ~CounterGroup() { close_all(); }
    CounterGroup(const CounterGroup&) = delete;
    CounterGroup& operator=(const CounterGroup&) = delete;

    /// The errno of opening the group; 0 if every event is open.
    [[nodiscard]] int error() const { return error_; }

    /// Starts counting from zero; false if the kernel refuses.
    bool start();

    /// Stops counting. Refused as parse_group and whole_time_only do.
    [[nodiscard]] Expected<GroupCount> stop();

  private:
    void close_all();

    std::array<int, largest_group> descriptors_{-1, -1, -1, -1};
    std::array<std::uint64_t, largest_group> ids_{};
    std::size_t size_ = 0;
    int error_ = 0;
    // The kernel's times run on when counts are reset.
    std::uint64_t enabled_before_ = 0, running_before_ = 0;
};

/// Counts from the words that the kernel wrote for a group with these ids: number of events, two times, then
/// value and id of each event. `bytes`: what read returned; 0 if a pinned group found no counters.
[[nodiscard]] Expected<GroupCount> parse_group(std::span<const std::uint64_t> words, std::int64_t bytes,
                                               std::span<const std::uint64_t> ids);

/// The count; refused unless it was on the counters all the time.
[[nodiscard]] Expected<GroupCount> whole_time_only(const GroupCount& count);

/// Count of an event over one batch, and what else happened during the batch.
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

/// Cost of counting, from counts of empty batches; refused for fewer than least_empty_batches.
[[nodiscard]] Expected<CountingCost> counting_cost(std::span<const std::uint64_t> empty_batches);

struct CounterFigure {
    double per_query = 0;
    std::size_t samples = 0;  ///< used
    std::size_t dropped = 0;  ///< disturbed, or shared their counter
};

/// Median of the good samples minus the overhead, divided by the queries of one batch.
[[nodiscard]] Expected<CounterFigure> count_per_query(std::span<const CounterSample> samples,
                                                      const CountingCost& cost, std::size_t queries);

}  // namespace edgewise::measure
