// SPDX-License-Identifier: MIT
//
// Which counters this machine has: every event of a short list is opened and counted over a small piece of
// work whose effects are known. An event that cannot be opened, was not on a counter all the time, or stayed
// at 0 where the work must cause it, is unavailable, with the reason and a remedy; it is never 0.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/measure/cpu.hpp"

namespace edgewise {

struct CounterRecord {
    std::string event;     ///< the name perf gives it
    std::string encoding;  ///< what was asked of the kernel, e.g. "PERF_TYPE_HARDWARE:0x3"
    std::optional<std::string>
        level;         ///< what it counts: "core", "L1D", "L2", "LLC" ...; null: not known here
    std::string unit;  ///< "1" or "ns"
    std::optional<std::uint64_t> value;  ///< over the reference work; null: unavailable
    int error = 0;                       ///< errno of opening it; 0: none
    std::string reason, remedy;          ///< when there is no value
};

/// What `value` was counted over, in words.
inline constexpr std::string_view reference_work =
    "256 fresh pages touched, then 100000 dependent loads over them in scattered order, then one short sleep";

/// Counts on the calling thread; takes some milliseconds.
[[nodiscard]] std::vector<CounterRecord> read_counters(const Cpu& cpu);

/// Why perf_event_open failed and what to do; fills `reason` and `remedy` from `error`.
void explain_error(CounterRecord& record, bool hardware, const Cpu& cpu);

}  // namespace edgewise
