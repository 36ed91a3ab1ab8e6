// SPDX-License-Identifier: MIT
//
// libpfm4: the library that turns a processor's own names of its events into codes for the kernel.
#pragma once

#include <string>

#include "edgewise/measure/counters/event_code.hpp"
#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

/// Why it cannot be used: left out of this build, or it did not start. Empty: it can be.
[[nodiscard]] std::string why_no_libpfm();

/// The code of an event with a name like "skx::MEM_LOAD_RETIRED:L1_MISS", user mode only; the processor at
/// hand may be another one.
[[nodiscard]] Expected<EventCode> encode_by_libpfm(const std::string& name);

}  // namespace edgewise::measure
