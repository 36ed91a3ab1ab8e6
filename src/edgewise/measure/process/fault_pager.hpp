// SPDX-License-Identifier: MIT
//
// A memory that is too small, which this process makes for itself: pages of a stretch of shared memory are
// unmapped and mapped again by userfaultfd (Linux 5.13 or later: minor faults of shared memory, reported to
// the thread that caused them). SegmentedLru decides which pages are held and evicted. A page that is not
// held is mapped after a given wait, the cost of a disk. Contents never move: an evicted page is only
// unmapped, so no answer can change. It needs no root, no disk and no control group.
//
// One pager at a time; only the thread that made it may use the memory meanwhile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "edgewise/measure/cache/segmented_lru.hpp"
#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

struct FaultCounts {
    std::uint64_t soft = 0, hard = 0;  ///< a page's first use is soft
};

class FaultPager {
  public:
    /// Takes the pages of the stretch from `base`, a page's start in shared memory; none of them may have
    /// been used. Refused if the kernel refuses or another pager exists.
    [[nodiscard]] static Expected<std::unique_ptr<FaultPager>> make(std::byte* base, std::size_t bytes,
                                                                    SegmentedLru memory);
    /// Makes all pages available again.
    ~FaultPager();
    FaultPager(const FaultPager&) = delete;
    FaultPager& operator=(const FaultPager&) = delete;

    /// Sets the wait of each hard fault from now on.
    void set_wait_ns(double ns);
    /// Counts since the pager was made, or since the last call.
    [[nodiscard]] FaultCounts take_counts();

  private:
    FaultPager() = default;
};

}  // namespace edgewise::measure
