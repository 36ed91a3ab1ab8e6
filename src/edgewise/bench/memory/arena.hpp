// SPDX-License-Identifier: MIT
//
// An arena for tables: one stretch of addresses that starts on a multiple of 2 MiB, filled from its start. So
// a table lies at the same offset on every machine and in every run, tables follow each other without
// headers, and a cache model gives the same result for an offset everywhere. Memory is given back all at
// once, when the arena is destroyed.
#pragma once

#include <cstddef>
#include <new>
#include <optional>

#include "edgewise/bench/memory/allocators.hpp"

namespace edgewise::bench {

// A stretch of addresses for an arena, from a multiple of 2 MiB on, that becomes memory page by page as it is
// written to: of no file, or of a temporary one that is gone with the mapping. Pages of a file can be written
// back and dropped, and read again one by one, so that memory can be too small for them without any swap;
// those of shared memory can be unmapped with their contents kept, for a pager (measure/process).

enum class Backing { memory, file, shared_memory };

class TableMapping {
  public:
    /// Alignment of the mapping's start: the size of a large page. The mapping does not use large pages, so
    /// that only written pages are resident.
    static constexpr std::size_t alignment = std::size_t{2} << 20;

    /// Reserves addresses, without memory. Throws std::runtime_error if there are no free addresses, or if
    /// every folder for the file is in memory itself.
    explicit TableMapping(Backing backing);
    ~TableMapping();
    TableMapping(const TableMapping&) = delete;
    TableMapping& operator=(const TableMapping&) = delete;

    [[nodiscard]] std::byte* base() const { return base_; }
    [[nodiscard]] static std::size_t bytes();

    /// Makes the first `bytes` bytes usable; call it before they are used. Where address space is short
    /// (ulimit -v, strict overcommit) addresses are taken step by step. Throws std::runtime_error if none are
    /// left.
    void make_room(std::size_t bytes) {
        if (bytes > room_) grow(bytes);
    }

    /// Returns true if the system evicts the least recently used pages first, as it does with other memory;
    /// else it may evict any.
    [[nodiscard]] bool keeps_recency() const { return keeps_recency_; }

    /// Bytes of resident pages among the first `used` bytes; nothing if the system does not report them.
    [[nodiscard]] std::optional<std::size_t> resident(std::size_t used) const;

    /// Writes the first `used` bytes back to the file and drops their pages, in this process and in the
    /// system's cache; false if that is not possible.
    [[nodiscard]] bool evict(std::size_t used) const;

  private:
    [[nodiscard]] std::byte* map(std::byte* at, std::size_t bytes, std::size_t offset) const;
    [[nodiscard]] bool reserve_all();
    void start_small();
    void grow(std::size_t bytes);
    void advise(std::byte* from, std::size_t bytes) const;

    Backing backing_;
    int file_ = -1;
    bool keeps_recency_ = true;
    std::byte* reserved_ = nullptr;  ///< base_ is the first multiple of `alignment` from here on
    std::byte* base_ = nullptr;
    std::size_t reserved_bytes_ = 0, room_ = 0;  ///< mapped from reserved_ on; to be used from base_ on
};

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
