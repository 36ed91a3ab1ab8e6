// SPDX-License-Identifier: MIT
//
// The allocators that tables may come from, side by side in one program and none in another's place: an
// arena, jemalloc, the C library, and arenas in a file and in shared memory. Each counts what was asked of it
// and what that really takes.
#pragma once

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <optional>
#include <span>
#include <string_view>

namespace edgewise::bench {

enum class AllocatorKind : std::uint8_t { arena, jemalloc, libc, file, memfd };

[[nodiscard]] std::string_view to_string(AllocatorKind kind);
/// Returns the kind with this name; nothing for an unknown name.
[[nodiscard]] std::optional<AllocatorKind> allocator_from(std::string_view name);

/// Name and one line for each.
struct AllocatorInfo {
    std::string_view name, summary;
};
[[nodiscard]] std::span<const AllocatorInfo> allocators_known();

class TableAllocator : public std::pmr::memory_resource {
  public:
    /// Bytes asked for and not given back.
    [[nodiscard]] std::size_t requested() const { return requested_; }
    /// Bytes that these take: size classes, headers and gaps included.
    [[nodiscard]] std::size_t taken() const { return taken_; }
    /// Bytes of pages really in memory; nothing where they cannot be separated from other memory.
    [[nodiscard]] virtual std::optional<std::size_t> resident() const { return std::nullopt; }
    /// The allocator's own count of what it has given out, where it keeps one.
    [[nodiscard]] virtual std::optional<std::size_t> by_its_statistics() const { return std::nullopt; }
    /// Start of its memory, if it is contiguous: offsets from there are the same in every run.
    [[nodiscard]] virtual const std::byte* base() const { return nullptr; }
    /// Drops its pages from memory, their content kept; false where it cannot.
    [[nodiscard]] virtual bool evict() const { return false; }
    /// Returns true if the system evicts the least recently used pages first.
    [[nodiscard]] virtual bool keeps_recency() const { return true; }

  protected:
    std::size_t requested_ = 0, taken_ = 0;

  private:
    [[nodiscard]] bool do_is_equal(const memory_resource& other) const noexcept override {
        return this == &other;
    }
};

/// Null when this program was built without it.
[[nodiscard]] std::unique_ptr<TableAllocator> make_jemalloc();

/// Throws std::runtime_error, with a remedy, when this program was built without it.
[[nodiscard]] std::unique_ptr<TableAllocator> make_allocator(AllocatorKind kind);

}  // namespace edgewise::bench
