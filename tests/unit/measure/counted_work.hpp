// SPDX-License-Identifier: MIT
//
// Work that causes an exact number of page faults, and the kernel's events that see it.
#pragma once

#include <linux/perf_event.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>

#include "edgewise/measure/counters/events.hpp"

namespace edgewise::measure {

inline constexpr EventCode software_page_faults{PERF_TYPE_SOFTWARE, PERF_COUNT_SW_PAGE_FAULTS};
inline constexpr EventCode software_task_clock{PERF_TYPE_SOFTWARE, PERF_COUNT_SW_TASK_CLOCK};

/// Touches `pages` fresh pages, with one page fault each.
inline void touch_pages(int pages) {
    if (pages == 0) return;
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t bytes = static_cast<std::size_t>(pages) * page;
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return;
    madvise(memory, bytes, MADV_NOHUGEPAGE);
    auto* const data = static_cast<volatile unsigned char*>(memory);
    for (std::size_t i = 0; i < bytes; i += page) data[i] = 1;
    munmap(memory, bytes);
}

}  // namespace edgewise::measure
