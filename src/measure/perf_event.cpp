// SPDX-License-Identifier: MIT
//
// glibc has no wrapper for perf_event_open, so the system call is made by number.
#include "edgewise/measure/perf_event.hpp"

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

namespace edgewise {

PerfEvent::PerfEvent(const EventCode& code) {
    perf_event_attr attributes{};
    attributes.size = sizeof attributes;
    attributes.type = code.type;
    attributes.config = code.config;
    attributes.disabled = 1;
    attributes.exclude_kernel = code.kernel_too ? 0 : 1;
    attributes.exclude_hv = 1;
    attributes.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
    // This thread (0), on whatever processor it runs (-1), in no group (-1).
    const long result = syscall(SYS_perf_event_open, &attributes, 0, -1, -1, PERF_FLAG_FD_CLOEXEC);
    if (result < 0) {
        error_ = errno;
    } else {
        descriptor_ = static_cast<int>(result);
    }
}

PerfEvent::~PerfEvent() {
    if (descriptor_ >= 0) close(descriptor_);
}

bool PerfEvent::start() {
    return descriptor_ >= 0 && ioctl(descriptor_, PERF_EVENT_IOC_RESET, 0) == 0 &&
           ioctl(descriptor_, PERF_EVENT_IOC_ENABLE, 0) == 0;
}

std::optional<EventCount> PerfEvent::stop() {
    std::uint64_t words[3] = {};
    if (descriptor_ < 0 || ioctl(descriptor_, PERF_EVENT_IOC_DISABLE, 0) != 0) return std::nullopt;
    if (read(descriptor_, words, sizeof words) != static_cast<ssize_t>(sizeof words)) return std::nullopt;
    return EventCount{words[0], words[1], words[2]};
}

}  // namespace edgewise
