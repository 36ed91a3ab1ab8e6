// SPDX-License-Identifier: MIT
#include "edgewise/measure/process/page_faults.hpp"

#include <sys/resource.h>

namespace edgewise::measure {

PageFaults page_faults() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return {static_cast<std::uint64_t>(usage.ru_minflt), static_cast<std::uint64_t>(usage.ru_majflt)};
}

}  // namespace edgewise::measure
