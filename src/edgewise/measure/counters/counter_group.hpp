// SPDX-License-Identifier: MIT
//
// One event, or a few counted together by the Linux kernel for the calling thread, over exactly the same
// instructions, so that their ratios are valid (man 2 perf_event_open). The group is pinned: it is on the
// counters the whole time or in error, and never shares them. A count that was on a counter only part of
// the time is refused; scaling it up would be a guess.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "edgewise/measure/counters/event_code.hpp"
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

    /// The errno of opening it; 0 when every event is open.
    [[nodiscard]] int error() const { return error_; }

    /// Counts from zero; false when the kernel refuses.
    bool start();

    [[nodiscard]] Expected<GroupCount> stop();

  private:
    bool open_all(std::span<const EventCode> events);
    void close_all();

    std::array<int, largest_group> descriptors_{-1, -1, -1, -1};
    std::array<std::uint64_t, largest_group> ids_{};
    std::size_t size_ = 0;
    int error_ = 0;
    // The kernel's times run on when counts are reset.
    std::uint64_t enabled_before_ = 0, running_before_ = 0;
};

/// What the kernel wrote for a group of that many events: number, two times, then value and id of each.
/// `bytes`: what read returned; 0 is how a pinned group says that it found no counters.
[[nodiscard]] Expected<GroupCount> parse_group(std::span<const std::uint64_t> words, std::int64_t bytes,
                                               std::span<const std::uint64_t> ids);

/// Refused unless it was on the counters all the time that it was asked for.
[[nodiscard]] Expected<GroupCount> whole_time_only(const GroupCount& count);

}  // namespace edgewise::measure
