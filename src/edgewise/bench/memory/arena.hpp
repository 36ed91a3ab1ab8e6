// SPDX-License-Identifier: MIT
//
// An arena for tables: one stretch of addresses that starts on a multiple of 2 MiB, filled from its start. So
// a table lies at the same offset on every machine and in every run, tables follow each other without
// headers, and what a cache model makes of an offset is the same everywhere. Memory is given back all at
// once, when the arena goes.
#pragma once

#include <new>

#include "edgewise/bench/memory/allocators.hpp"
#include "edgewise/bench/memory/table_mapping.hpp"

namespace edgewise::bench {

class Arena final : public TableAllocator {
  public:
    /// Throws as TableMapping does.
    explicit Arena(Backing backing = Backing::memory) : mapping_(backing) {}

    [[nodiscard]] std::optional<std::size_t> resident() const override { return mapping_.resident(taken_); }
    [[nodiscard]] const std::byte* base() const override { return mapping_.base(); }
    [[nodiscard]] bool evict() const override { return mapping_.evict(taken_); }
    [[nodiscard]] bool keeps_recency() const override { return mapping_.keeps_recency(); }

  private:
    void* do_allocate(std::size_t bytes, std::size_t align) override {
        const std::size_t start = (taken_ + align - 1) / align * align;
        if (bytes > TableMapping::bytes() || start > TableMapping::bytes() - bytes) throw std::bad_alloc();
        mapping_.make_room(start + bytes);
        taken_ = start + bytes;
        requested_ += bytes;
        return mapping_.base() + start;
    }
    void do_deallocate(void* /*memory*/, std::size_t bytes, std::size_t /*align*/) override {
        requested_ -= bytes;
    }

    TableMapping mapping_;
};

}  // namespace edgewise::bench
