// SPDX-License-Identifier: MIT
//
// While one lives, Callgrind collects, if the program runs under it with --collect-atstart=no; else nothing.
#pragma once

namespace edgewise::measure {

class CallgrindRegion {
  public:
    /// Returns true if this program was built with the header that it needs (valgrind/callgrind.h).
    [[nodiscard]] static bool available();

    CallgrindRegion();
    ~CallgrindRegion();
    CallgrindRegion(const CallgrindRegion&) = delete;
    CallgrindRegion& operator=(const CallgrindRegion&) = delete;
};

}  // namespace edgewise::measure
