// SPDX-License-Identifier: MIT
//
// One table, one aligned block of memory. A layout names its arrays and the purpose of each byte of an
// element. It is called three times: to size the block, to place the arrays in it, and to list the pieces. So
// nothing is kept next to the block, the ledger is what was really allocated, and an address inside the block
// is the same on every machine.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <type_traits>
#include <utility>
#include <vector>

#include "edgewise/table/pieces.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise {

/// Rounds up to the next whole multiple of `to`.
[[nodiscard]] constexpr std::size_t rounded_up(std::size_t bytes, std::size_t to) {
    return (bytes + to - 1) / to * to;
}

/// Plans arrays one after another, in the order in which they are named.
class BlockPlan {
  public:
    /// Arrays start on cache lines, so that how they share lines does not depend on their neighbours' sizes;
    /// but an array shorter than a line follows directly: in a small body these gaps would be half of the
    /// table.
    static constexpr std::size_t alignment = 64;
    /// A block shorter than this is aligned for its elements only, for the same reason.
    static constexpr std::size_t small = 4 * alignment;

    /// Computes sizes only.
    BlockPlan() = default;
    /// Places the arrays in a block of memory that starts here.
    explicit BlockPlan(std::byte* base) : base_(base) {}

    /// Adds an array. When it places, begins the array and points `to` at it: its elements exist, without a
    /// value yet, and no memory is written for it.
    template <class Element>
    void array(Element*& to, std::size_t count, const Shares& shares) {
        const std::size_t start = array_at<Element>(count, shares);
        if (base_) to = reinterpret_cast<Element*>(base_ + start);
    }

    /// Adds an array without a pointer. Returns its start, in bytes from the block's start.
    template <class Element>
    std::uint32_t array_at(std::size_t count, const Shares& shares) {
        static_assert(std::is_trivially_destructible_v<Element> && alignof(Element) <= alignment);
        const std::size_t start = records_at({sizeof(Element), alignof(Element)}, count, shares);
        if (base_) std::uninitialized_default_construct_n(reinterpret_cast<Element*>(base_ + start), count);
        return static_cast<std::uint32_t>(start);
    }

    struct RecordSize {
        std::size_t bytes, alignment;
    };

    /// Adds records without a type: the caller reads and writes their bytes. Returns their start, in bytes.
    std::size_t records_at(const RecordSize& record, std::size_t count, const Shares& shares) {
        assert(record.alignment <= alignment && record.bytes % record.alignment == 0);
        const std::size_t to = count * record.bytes < alignment ? record.alignment : alignment;
        const std::size_t start = rounded_up(size_, to);
        add_piece(1, start - size_, {});
        add_piece(record.bytes, count, shares);
        element_alignment_ = std::max(element_alignment_, record.alignment);
        return start;
    }

    /// Adds one element directly behind the last, of any size: for records of several lengths, which rely on
    /// lines. Returns its start.
    std::size_t append(std::size_t bytes, const Shares& shares) {
        const std::size_t start = size_;
        element_alignment_ = alignment;
        add_piece(bytes, 1, shares);
        return start;
    }

    /// Start of the block; null when it only sizes.
    [[nodiscard]] std::byte* base() const { return base_; }
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] std::size_t block_alignment() const {
        return size_ < small ? element_alignment_ : alignment;
    }
    /// Pieces in memory order, without gaps, in a block that starts at `base` (null: not placed yet).
    [[nodiscard]] std::vector<Piece> pieces(const std::byte* base) const {
        std::vector<Piece> placed = pieces_;
        std::size_t offset = 0;
        for (Piece& piece : placed) {
            piece.at = base ? base + offset : nullptr;
            offset += piece.bytes();
        }
        return placed;
    }

  private:
    void add_piece(std::size_t stride, std::size_t count, const Shares& shares) {
        assert(shares.bytes() <= stride);
        size_ += stride * count;
        if (count == 0) return;
        if (!pieces_.empty() && pieces_.back().stride == stride && pieces_.back().shares == shares) {
            pieces_.back().count += count;
        } else {
            pieces_.push_back({nullptr, stride, count, shares});
        }
    }

    std::byte* base_ = nullptr;
    std::size_t size_ = 0, element_alignment_ = 1;
    std::vector<Piece> pieces_;  // not placed yet
};

/// Memory of one owner, which alone gives it back, and of views that borrow it and must not outlive the
/// owner. Only requested writes touch the memory: a page of planes that a lazy table never makes is never
/// resident.
class Block {
  public:
    Block() = default;
    /// Allocates memory for the arrays of name_arrays(BlockPlan&), called twice: to size and to place.
    template <class NameArrays>
    explicit Block(const NameArrays& name_arrays) : Block() {
        BlockPlan sizes;
        name_arrays(sizes);
        assert(sizes.size() >> 32 == 0 && "a table of more than 4 GiB");
        extent_ = {static_cast<std::uint32_t>(sizes.size()),
                   static_cast<std::uint32_t>(sizes.block_alignment())};
        memory_ = static_cast<std::byte*>(table_memory().allocate(extent_.bytes, extent_.alignment));
        owner_ = &table_memory();
        BlockPlan places(memory_);
        name_arrays(places);
        assert(places.size() == extent_.bytes);
    }
    ~Block() {
        if (owner_) owner_->deallocate(memory_, extent_.bytes, extent_.alignment);
    }
    Block(Block&& other) noexcept
        : owner_(std::exchange(other.owner_, nullptr)), memory_(other.memory_), extent_(other.extent_) {}
    Block& operator=(Block&& other) noexcept {
        std::swap(owner_, other.owner_);
        std::swap(memory_, other.memory_);
        std::swap(extent_, other.extent_);
        return *this;
    }

    /// Returns a view that borrows the same memory.
    [[nodiscard]] Block view() const {
        Block borrowed;
        borrowed.memory_ = memory_;
        borrowed.extent_ = extent_;
        return borrowed;
    }

    [[nodiscard]] std::byte* base() const { return memory_; }
    [[nodiscard]] std::size_t size() const { return extent_.bytes; }

  private:
    /// Size and alignment in one word, so that a small table's object is one cache line.
    struct Extent {
        std::uint32_t bytes = 0, alignment = 1;
    };

    std::pmr::memory_resource* owner_ = nullptr;  // none: borrowed, or nothing
    std::byte* memory_ = nullptr;
    Extent extent_;
};

}  // namespace edgewise
