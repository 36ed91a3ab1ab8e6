// SPDX-License-Identifier: MIT
//
// A memory that is too small, made by this process for itself: a stretch of shared memory whose pages are
// taken away and given back by userfaultfd (Linux 5.13 on: minor faults of shared memory, reported to the
// thread that caused them). SegmentedLru decides which pages are held and evicted; a page that is not held
// comes after a stated wait, the cost of a disk. Contents never move: an evicted page is only unmapped, so
// that no answer can change. No root, no disk, no control group.
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
    double waited_ns = 0;              ///< in hard faults, as stated
};

class FaultPager {
  public:
    /// Pages of the stretch from `base`, a page's start in shared memory, none of them used yet.
    /// Nothing, with the reason, where the kernel refuses or another pager lives.
    [[nodiscard]] static Expected<std::unique_ptr<FaultPager>> make(std::byte* base, std::size_t bytes,
                                                                    SegmentedLru memory);
    /// All pages are there again.
    ~FaultPager();
    FaultPager(const FaultPager&) = delete;
    FaultPager& operator=(const FaultPager&) = delete;

    /// Sets the wait of each hard fault from now on.
    void set_wait_ns(double ns);
    /// Since it was made, or taken last.
    [[nodiscard]] FaultCounts take_counts();

  private:
    FaultPager() = default;
};

}  // namespace edgewise::measure
