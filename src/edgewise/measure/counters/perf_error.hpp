// SPDX-License-Identifier: MIT
//
// Why perf_event_open failed, and what to do (man 2 perf_event_open): no counters at all, no permission, an
// event that is not there and no counter free are different, and so is what helps.
#pragma once

#include "edgewise/measure/expected.hpp"
#include "edgewise/measure/machine/cpu.hpp"

namespace edgewise::measure {

/// `error`: the errno. `hardware`: the event is the processor's, not the kernel's own.
[[nodiscard]] Refusal explain_error(int error, bool hardware, const Cpu& cpu);

}  // namespace edgewise::measure
