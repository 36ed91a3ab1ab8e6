// SPDX-License-Identifier: MIT
//
// A build without libpfm4: events are found by their raw codes or by the kernel's generic names.
#include "edgewise/measure/counters/libpfm.hpp"

namespace edgewise::measure {

namespace {

constexpr const char* left_out = "this build is without libpfm (Debian: libpfm4-dev)";

}  // namespace

std::string why_no_libpfm() { return left_out; }

Expected<EventCode> encode_by_libpfm(const std::string& /*name*/) {
    return Expected<EventCode>::none(left_out);
}

}  // namespace edgewise::measure
