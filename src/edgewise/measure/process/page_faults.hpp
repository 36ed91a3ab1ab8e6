// SPDX-License-Identifier: MIT
//
// Page faults of this process so far, as the kernel counts them (man 2 getrusage). Major ones had to wait for
// a disk.
#pragma once

#include <cstdint>

namespace edgewise::measure {

struct PageFaults {
    std::uint64_t minor = 0, major = 0;

    [[nodiscard]] PageFaults since(const PageFaults& before) const {
        return {minor - before.minor, major - before.major};
    }
};

[[nodiscard]] PageFaults page_faults();

}  // namespace edgewise::measure
