// SPDX-License-Identifier: MIT
#include "edgewise/measure/process/thread_usage.hpp"

#include <sys/resource.h>

namespace edgewise::measure {

ThreadUsage thread_usage() {
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);  // cannot fail with these arguments
    return {static_cast<std::uint64_t>(usage.ru_minflt), static_cast<std::uint64_t>(usage.ru_majflt),
            static_cast<std::uint64_t>(usage.ru_nvcsw) + static_cast<std::uint64_t>(usage.ru_nivcsw)};
}

}  // namespace edgewise::measure
