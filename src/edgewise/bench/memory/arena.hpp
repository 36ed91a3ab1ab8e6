// SPDX-License-Identifier: MIT
//
// An arena for tables: one stretch of addresses that starts on a multiple of 2 MiB, filled from its start. So
// a table lies at the same offset on every machine and in every run, tables follow each other without
// headers, and what a cache model makes of an offset is the same everywhere. Memory is given back all at
// once, when the arena goes.
#pragma once

#include <cstddef>
#include <memory_resource>

#include "edgewise/bench/memory/table_mapping.hpp"

namespace edgewise::bench {

class Arena final : public std::pmr::memory_resource {
  public:
    /// Throws as TableMapping does.
    explicit Arena(Backing backing = Backing::memory) : mapping_(backing) {}

    [[nodiscard]] const TableMapping& mapping() const { return mapping_; }
    [[nodiscard]] const std::byte* base() const { return mapping_.base(); }
    /// Bytes from the start that are taken, gaps for alignment included.
    [[nodiscard]] std::size_t used() const { return used_; }
    /// Bytes of pages that the operating system has really given to it; nothing when it does not say.
    [[nodiscard]] std::optional<std::size_t> resident() const { return mapping_.resident(used_); }

  private:
    void* do_allocate(std::size_t bytes, std::size_t align) override;
    void do_deallocate(void* /*memory*/, std::size_t /*bytes*/, std::size_t /*align*/) override {}
    [[nodiscard]] bool do_is_equal(const memory_resource& other) const noexcept override {
        return this == &other;
    }

    TableMapping mapping_;
    std::size_t used_ = 0;
};

}  // namespace edgewise::bench
