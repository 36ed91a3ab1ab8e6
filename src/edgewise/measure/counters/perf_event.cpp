// SPDX-License-Identifier: MIT
//
// glibc has no wrapper for perf_event_open, so the system call is made by number.
#include "edgewise/measure/counters/perf_event.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>

namespace edgewise::measure {

std::string encoding_text(const EventCode& code) {
    const char* const type = code.type == PERF_TYPE_HARDWARE   ? "PERF_TYPE_HARDWARE"
                             : code.type == PERF_TYPE_HW_CACHE ? "PERF_TYPE_HW_CACHE"
                             : code.type == PERF_TYPE_SOFTWARE ? "PERF_TYPE_SOFTWARE"
                             : code.type == PERF_TYPE_RAW      ? "PERF_TYPE_RAW"
                                                               : nullptr;
    const std::string name = type != nullptr ? type : fmt::format("type {}", code.type);
    return fmt::format("{}:{:#x}{}", name, code.config, code.kernel_too ? "" : ":u");
}

int open_event(const EventCode& code, int leader, bool pinned, std::uint64_t read_format) {
    perf_event_attr attributes{};
    attributes.size = sizeof attributes;
    attributes.type = code.type;
    attributes.config = code.config;
    if (leader < 0) attributes.disabled = 1;  // the members of a group follow its leader
    if (pinned) attributes.pinned = 1;
    attributes.exclude_kernel = code.kernel_too ? 0 : 1;
    attributes.exclude_hv = 1;
    attributes.read_format = read_format;
    // This thread (0), on whatever processor it runs (-1).
    const long result = syscall(SYS_perf_event_open, &attributes, 0, -1, leader, PERF_FLAG_FD_CLOEXEC);
    return result < 0 ? -errno : static_cast<int>(result);
}

PerfEvent::PerfEvent(const EventCode& code) {
    const int result =
        open_event(code, -1, false, PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING);
    if (result < 0) {
        error_ = -result;
    } else {
        descriptor_ = result;
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

}  // namespace edgewise::measure
