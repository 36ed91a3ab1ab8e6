// SPDX-License-Identifier: MIT
//
// A build without libpfm4: no event of the processor has a code.
#include "edgewise/measure/counters/events.hpp"

namespace edgewise::measure {

std::string why_no_libpfm() { return "this build is without libpfm (Debian: libpfm4-dev)"; }

Expected<EventCode> encode_by_libpfm(const std::string& /*name*/) { return Refusal{why_no_libpfm()}; }

}  // namespace edgewise::measure
