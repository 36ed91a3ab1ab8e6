// SPDX-License-Identifier: MIT
//
// Processor time of the calling thread: what a piece of work costs on a machine that others use too. Beside
// the wall clock it leaves out waiting, and keeps what neighbours take of caches and of a shared core.
#pragma once

#include <time.h>

namespace edgewise::measure {

/// Seconds since the thread began; reading it takes some hundred ns.
[[nodiscard]] inline double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);  // cannot fail with these arguments
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace edgewise::measure
