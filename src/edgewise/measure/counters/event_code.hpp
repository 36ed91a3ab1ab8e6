// SPDX-License-Identifier: MIT
//
// How the Linux kernel is asked for an event, and what its refusals mean (man 2 perf_event_open): no counters
// at all, no permission, an event that is not there and no counter free are different, and so is what helps.
#pragma once

#include <cstdint>
#include <string>

#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/machine/cpu.hpp"

namespace edgewise::measure {

struct EventCode {
    std::uint32_t type = 0;    ///< PERF_TYPE_*
    std::uint64_t config = 0;  ///< of that type
    bool kernel_too = false;   ///< else only what happens in user mode
};

/// "PERF_TYPE_RAW:0x8d1:u"; u: user mode only.
[[nodiscard]] std::string encoding_text(const EventCode& code);

/// `error`: the errno. `hardware`: the event is the processor's, not the kernel's own.
[[nodiscard]] Refusal explain_error(int error, bool hardware, const Cpu& cpu);

}  // namespace edgewise::measure
