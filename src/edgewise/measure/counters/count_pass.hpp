// SPDX-License-Identifier: MIT
//
// Counts the processor's events over a pass of queries. Events are counted four at a time, each group in
// passes of its own: sharing counters would need scaling. So `pass` must do the same work each time, on the
// calling thread. Each group is calibrated by empty batches (counter_group.hpp).
//
// Also counts what the operating system did to the thread during a pass: page faults, context switches, moves
// to another processor. These exist on processors without counters too. Here 0 is a value: a steady pass
// shows it.
//
// Also the inventory of this machine's counters: the event of every metric and the kernel's own events are
// opened and counted over a small piece of work with known effects. An event is unavailable, with the reason
// and a remedy, if it cannot be opened, was not on a counter all the time, or stayed at 0 although the work
// must cause it; it is never 0.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "edgewise/measure/counters/events.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {

/// An event over a pass. Without a value, `refusal` says why; `error` is the errno if the event did not open.
struct PassRecord : ChosenEvent {
    std::optional<double> value = {};  ///< per query
    std::uint64_t overhead = 0;        ///< of counting, taken off each pass
    std::uint64_t floor = 0;           ///< a pass must have counted ten times this
    std::size_t samples = 0;           ///< passes that the value comes from
    std::size_t dropped = 0;           ///< passes that were disturbed
};

struct CountedPass {
    std::vector<PassRecord> records;  ///< one per event, in the order of the events
    std::size_t passes = 0;           ///< how often `pass` was called
};

struct CountOptions {
    std::size_t samples = 5;          ///< undisturbed passes wanted per group
    std::size_t most_passes = 12;     ///< per group, disturbed ones included
    std::size_t empty_batches = 101;  ///< per group
};

/// Counts every metric of events.hpp. If no event can be opened, which is tried once per process, `pass` is
/// never called. `cpu`: this machine's.
[[nodiscard]] CountedPass count_pass(const std::function<void()>& pass, std::size_t queries, const Cpu& cpu);

/// Counts any events, as count_pass does; events with a refusal keep it in the result.
[[nodiscard]] CountedPass count_events(const std::function<void()>& pass, std::size_t queries,
                                       std::span<const ChosenEvent> events, const CountOptions& options = {});

/// Counts minor_faults, major_faults, context_switches and cpu_migrations of one pass.
[[nodiscard]] std::vector<PassRecord> count_software(const std::function<void()>& pass, std::size_t queries,
                                                     const Cpu& cpu);

/// An event of this machine, with its count.
struct CounterRecord : ChosenEvent {
    std::optional<std::uint64_t> value;  ///< over the reference work; null: unavailable, see refusal
};

/// The work over which `value` was counted, in words.
inline constexpr std::string_view reference_work =
    "256 fresh pages touched, then 100000 dependent loads over them in scattered order, then one short sleep";

/// Counts every metric and the kernel's own events on the calling thread; takes some milliseconds.
[[nodiscard]] std::vector<CounterRecord> read_counters(const Cpu& cpu);

}  // namespace edgewise::measure
