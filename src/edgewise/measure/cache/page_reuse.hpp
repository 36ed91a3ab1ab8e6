// SPDX-License-Identifier: MIT
//
// Reuse distances of the tables' pages alone: what a memory of any size would have to fetch again, if it
// evicted the page that was not used for longest.
#pragma once

#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

class PageReuse final : public TraceListener {
  public:
    explicit PageReuse(std::uint64_t page_bytes) : page_bytes_(page_bytes) {}

    void on_access(const TracedAccess& access) override {
        if (access.side == TraceSide::scene) return;
        const std::uint64_t last = (access.address + access.bytes - 1) / page_bytes_;
        for (std::uint64_t page = access.address / page_bytes_; page <= last; ++page) reuse_.use(page);
    }
    void on_query_end(bool /*counts*/) override { ++queries_; }

    /// What came before is known but not counted.
    void start_counting() {
        queries_ = 0;
        reuse_.forget_curve();
    }

    /// Distinct pages so far.
    [[nodiscard]] std::uint64_t pages() const { return reuse_.lines(); }
    /// Fetches per query in a memory of so many pages.
    [[nodiscard]] double fetches_per_query(std::uint64_t memory_pages) const {
        return static_cast<double>(reuse_.curve().misses(memory_pages)) / static_cast<double>(queries_);
    }

  private:
    std::uint64_t page_bytes_;
    ReuseDistance reuse_;
    std::uint64_t queries_ = 0;
};

}  // namespace edgewise::measure
