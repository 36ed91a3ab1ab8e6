// SPDX-License-Identifier: MIT
//
// Which counters this machine has: every metric's event and the kernel's own events are opened and counted
// over a small piece of work with known effects. An event that cannot be opened, was not on a counter
// all the time, or stayed at 0 where the work must cause it, is unavailable, with the reason and a remedy; it
// is never 0.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "edgewise/measure/counters/event_choice.hpp"
#include "edgewise/measure/machine/cpu.hpp"

namespace edgewise::measure {

struct CounterRecord : ChosenEvent {
    std::optional<std::uint64_t> value;  ///< over the reference work; null: unavailable, see refusal
};

/// What `value` was counted over, in words.
inline constexpr std::string_view reference_work =
    "256 fresh pages touched, then 100000 dependent loads over them in scattered order, then one short sleep";

/// Counts on the calling thread; takes some milliseconds.
[[nodiscard]] std::vector<CounterRecord> read_counters(const Cpu& cpu);

}  // namespace edgewise::measure
