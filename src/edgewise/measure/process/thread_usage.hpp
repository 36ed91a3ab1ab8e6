// SPDX-License-Identifier: MIT
//
// What the kernel did to the calling thread so far: man 2 getrusage, which needs no permission, where the
// kernel's events of the same things do.
#pragma once

#include <cstdint>

namespace edgewise::measure {

struct ThreadUsage {
    std::uint64_t minor_faults = 0, major_faults = 0;
    std::uint64_t context_switches = 0;  ///< given up or taken away; a move to another processor is one too

    friend ThreadUsage operator-(const ThreadUsage& later, const ThreadUsage& earlier) {
        return {later.minor_faults - earlier.minor_faults, later.major_faults - earlier.major_faults,
                later.context_switches - earlier.context_switches};
    }
};

/// Since the thread began.
[[nodiscard]] ThreadUsage thread_usage();

}  // namespace edgewise::measure
