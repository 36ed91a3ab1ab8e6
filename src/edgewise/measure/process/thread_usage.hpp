// SPDX-License-Identifier: MIT
//
// Page faults, context switches and time of the calling thread: man 2 getrusage, which needs no permission;
// the kernel's events of the same name do.
#pragma once

#include <sys/resource.h>
#include <time.h>

#include <cstdint>

namespace edgewise::measure {

struct ThreadUsage {
    std::uint64_t minor_faults = 0, major_faults = 0;  ///< of pages; major ones had to wait for a disk
    std::uint64_t context_switches = 0;  ///< given up or taken away; a move to another processor is one too

    friend ThreadUsage operator-(const ThreadUsage& later, const ThreadUsage& earlier) {
        return {later.minor_faults - earlier.minor_faults, later.major_faults - earlier.major_faults,
                later.context_switches - earlier.context_switches};
    }
};

/// Counts since the thread began.
[[nodiscard]] inline ThreadUsage thread_usage() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);  // cannot fail with these arguments
    return {static_cast<std::uint64_t>(usage.ru_minflt), static_cast<std::uint64_t>(usage.ru_majflt),
            static_cast<std::uint64_t>(usage.ru_nvcsw) + static_cast<std::uint64_t>(usage.ru_nivcsw)};
}

/// Seconds since the thread began; reading it takes some hundred ns.
[[nodiscard]] inline double thread_seconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);  // cannot fail with these arguments
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace edgewise::measure
