// SPDX-License-Identifier: MIT
//
// An arena for tables: one stretch of addresses that starts on a multiple of 2 MiB, filled from its start. So
// a table lies at the same offset on every machine and in every run, tables follow each other without
// headers, and a cache model gives the same result for an offset everywhere. Memory is given back all at
// once, when the arena is destroyed.
//
// The stretch becomes memory page by page as it is written to: of no file, or of a temporary one that is gone
// with the arena. Pages of a file can be written back and dropped, and read again one by one, so that memory
// can be too small for them without any swap; those of shared memory can be unmapped with their contents
// kept, for a pager (measure/process).
#pragma once

#include <cstddef>
#include <optional>

#include "edgewise/bench/memory/allocators.hpp"

namespace edgewise::bench {

enum class Backing { memory, file, shared_memory };

class Arena final : public TableAllocator {
  public:
    /// Alignment of the arena's start: the size of a large page. The arena does not use large pages, so that
    /// only written pages are resident.
    static constexpr std::size_t alignment = std::size_t{2} << 20;

    /// Reserves addresses, without memory. Throws std::runtime_error if there are no free addresses, or if
    /// every folder for the file is in memory itself.
    explicit Arena(Backing backing = Backing::memory);
    ~Arena() override;
    Arena(const Arena&) = delete;
    Arena& operator=(const Arena&) = delete;

    [[nodiscard]] std::optional<std::size_t> resident() const override;
    [[nodiscard]] const std::byte* base() const override { return base_; }
    /// Writes its pages back to the file and drops them, in this process and in the system's cache.
    [[nodiscard]] bool evict() const override;
    [[nodiscard]] bool keeps_recency() const override { return keeps_recency_; }

  private:
    void* do_allocate(std::size_t bytes, std::size_t align) override;
    void do_deallocate(void* /*memory*/, std::size_t bytes, std::size_t /*align*/) override {
        requested_ -= bytes;
    }

    [[nodiscard]] std::byte* map(std::byte* at, std::size_t bytes, std::size_t offset) const;
    [[nodiscard]] bool reserve_all();
    void start_small();
    /// Makes the first `bytes` bytes usable. Where address space is short (ulimit -v, strict overcommit)
    /// addresses are taken step by step. Throws std::runtime_error if none are left.
    void grow(std::size_t bytes);
    void advise(std::byte* from, std::size_t bytes) const;

    Backing backing_;
    int file_ = -1;
    bool keeps_recency_ = true;
    std::byte* reserved_ = nullptr;  ///< base_ is the first multiple of `alignment` from here on
    std::byte* base_ = nullptr;
    std::size_t reserved_bytes_ = 0, room_ = 0;  ///< mapped from reserved_ on; to be used from base_ on
};

}  // namespace edgewise::bench
