// SPDX-License-Identifier: MIT
#include "edgewise/measure/counters/event_code.hpp"

#include <fmt/core.h>
#include <linux/perf_event.h>

#include <cerrno>
#include <cstring>

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

Refusal explain_error(int error, bool hardware, const Cpu& cpu) {
    const bool guest = cpu.hypervisor.value.value_or(false);
    const std::string words = std::strerror(error);
    const auto is_one_of = [&](auto... codes) { return ((error == codes) || ...); };
    if (is_one_of(EACCES, EPERM)) {
        return {"no permission: " + words,
                "as root: sysctl kernel.perf_event_paranoid=1, or give the program CAP_PERFMON; "
                "in a container also allow perf_event_open in its seccomp profile"};
    }
    if (is_one_of(ENOENT, EOPNOTSUPP, ENODEV) && hardware && guest) {
        return {"this virtual machine has no performance counters for it: " + words,
                "have the hypervisor pass the PMU through (KVM: -cpu host,pmu=on), or run on the bare "
                "machine"};
    }
    if (is_one_of(ENOENT, EOPNOTSUPP, ENODEV, EINVAL)) {
        return {"this processor or kernel does not have the event: " + words,
                "use a kernel that knows the processor"};
    }
    if (error == ENOSYS) {
        return {"the kernel has no perf_event_open: " + words,
                "use a kernel with CONFIG_PERF_EVENTS, outside of a sandbox that emulates system calls"};
    }
    if (is_one_of(EBUSY, EMFILE, ENOSPC)) {
        return {"no counter or file descriptor free: " + words,
                "end other users of the counters, or raise ulimit -n"};
    }
    return {words, "see man 2 perf_event_open"};
}

}  // namespace edgewise::measure
