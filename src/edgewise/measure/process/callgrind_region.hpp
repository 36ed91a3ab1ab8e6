// SPDX-License-Identifier: MIT
//
// While one lives, Callgrind collects, if the program runs under it with --collect-atstart=no; else nothing.
#pragma once

namespace edgewise::measure {

class CallgrindRegion {
  public:
    /// Whether this program was built with what it takes (valgrind/callgrind.h).
    [[nodiscard]] static bool available();

    CallgrindRegion();
    ~CallgrindRegion();
    CallgrindRegion(const CallgrindRegion&) = delete;
    CallgrindRegion& operator=(const CallgrindRegion&) = delete;
};

}  // namespace edgewise::measure
