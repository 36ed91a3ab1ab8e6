// SPDX-License-Identifier: MIT
//
// One event counted by the Linux kernel for the calling thread (man 2 perf_event_open).
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace edgewise::measure {

struct EventCode {
    std::uint32_t type = 0;    ///< PERF_TYPE_*
    std::uint64_t config = 0;  ///< of that type
    bool kernel_too = false;   ///< else only what happens in user mode
};

/// "PERF_TYPE_RAW:0x8d1:u"; u: user mode only.
[[nodiscard]] std::string encoding_text(const EventCode& code);

/// What the system call takes for it: disabled, in user mode unless it says otherwise. Returns the
/// descriptor, or -errno. `leader`: of the group to join, -1 for none.
[[nodiscard]] int open_event(const EventCode& code, int leader, bool pinned, std::uint64_t read_format);

struct EventCount {
    std::uint64_t value = 0;
    std::uint64_t enabled_ns = 0;  ///< how long it was asked for
    std::uint64_t running_ns =
        0;  ///< how long it was on a counter; less than enabled: multiplexed, do not use
};

class PerfEvent {
  public:
    explicit PerfEvent(const EventCode& code);
    ~PerfEvent();
    PerfEvent(const PerfEvent&) = delete;
    PerfEvent& operator=(const PerfEvent&) = delete;

    /// The errno of opening it; 0 when it is open.
    [[nodiscard]] int error() const { return error_; }
    /// Counts from zero; false when the kernel refuses.
    bool start();
    /// Null when the kernel gives no count (a pinned event that found no counter reads as end of file).
    std::optional<EventCount> stop();

  private:
    int descriptor_ = -1;
    int error_ = 0;
};

}  // namespace edgewise::measure
