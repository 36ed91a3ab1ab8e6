// SPDX-License-Identifier: MIT
//
// man 3 pfm_get_os_event_encoding. Only codes are taken from libpfm; privilege levels and groups are set
// where events are opened.
#include "edgewise/measure/counters/events.hpp"

#include <fmt/core.h>
#include <perfmon/pfmlib.h>
#include <perfmon/pfmlib_perf_event.h>

#include <cstdlib>

namespace edgewise::measure {

/// Starts the library at the first use and never ends it. It encodes for processors that it does not detect,
/// too, because 4.13 detects no desktop Zen 3 and 4: the caller names the processor.
std::string why_no_libpfm() {
    static const int result = [] {
        setenv("LIBPFM_ENCODE_INACTIVE", "1", 0);
        return pfm_initialize();
    }();
    return result == PFM_SUCCESS ? "" : fmt::format("libpfm does not start: {}", pfm_strerror(result));
}

Expected<EventCode> encode_by_libpfm(const std::string& name) {
    if (const std::string why = why_no_libpfm(); !why.empty()) return Refusal{why};
    perf_event_attr attributes{};
    pfm_perf_encode_arg_t request{};
    request.attr = &attributes;
    request.size = sizeof request;
    attributes.size = sizeof attributes;
    const int result = pfm_get_os_event_encoding(name.c_str(), PFM_PLM3, PFM_OS_PERF_EVENT, &request);
    if (result != PFM_SUCCESS) return Refusal{fmt::format("libpfm: {}: {}", name, pfm_strerror(result))};
    return {EventCode{attributes.type, attributes.config}};
}

}  // namespace edgewise::measure
