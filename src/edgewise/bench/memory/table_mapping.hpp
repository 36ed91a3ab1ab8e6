// SPDX-License-Identifier: MIT
//
// A stretch of addresses for an arena, from a multiple of 2 MiB on, that becomes memory page by page as it is
// written to: of no file, or of a temporary one that is gone with the mapping. Pages of a file can be written
// back and dropped, and read again one by one, so that memory can be too small for them without any swap;
// those of shared memory can be unmapped with their contents kept, for a pager (measure/process).
#pragma once

#include <cstddef>
#include <optional>

namespace edgewise::bench {

enum class Backing { memory, file, shared_memory };

class TableMapping {
  public:
    /// Alignment of its start: the size of a large page. Large pages are declined all the same, so that only
    /// written pages are resident.
    static constexpr std::size_t alignment = std::size_t{2} << 20;

    /// Takes no memory yet, only addresses. Throws std::runtime_error when there are not even those, or when
    /// no folder takes a file that is not kept in memory itself.
    explicit TableMapping(Backing backing);
    ~TableMapping();
    TableMapping(const TableMapping&) = delete;
    TableMapping& operator=(const TableMapping&) = delete;

    [[nodiscard]] std::byte* base() const { return base_; }
    [[nodiscard]] static std::size_t bytes();

    /// Must be called before the first `bytes` bytes are used. Where address space is short (ulimit -v,
    /// strict overcommit) addresses come step by step. Throws std::runtime_error when none are left.
    void make_room(std::size_t bytes) {
        if (bytes > room_) grow(bytes);
    }

    /// Returns true if the system evicts the least recently used pages, as with other memory; if false, it
    /// may evict any.
    [[nodiscard]] bool keeps_recency() const { return keeps_recency_; }

    /// Number of the first `used` bytes with pages in memory; nothing when the system does not report it.
    [[nodiscard]] std::optional<std::size_t> resident(std::size_t used) const;

    /// Writes the first bytes back to the file and drops their pages, in this process and in the system's
    /// cache; false where that is not possible.
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

}  // namespace edgewise::bench
