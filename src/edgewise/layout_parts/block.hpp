// SPDX-License-Identifier: MIT
//
// One table, one aligned block of memory. A layout first plans its arrays, saying what each byte of an
// element is for; then the block is allocated once and the arrays are placed at fixed offsets. So the ledger
// is what was really allocated, and an address inside the block is the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

#include "edgewise/table/pieces.hpp"
#include "edgewise/table/table_memory.hpp"

namespace edgewise {

template <class Element>
struct Slot {
    std::size_t offset;
    std::size_t count;
};

class BlockPlan {
  public:
    /// Arrays start on cache lines, so that how they share lines does not depend on their neighbours' sizes.
    static constexpr std::size_t alignment = 64;

    template <class Element>
    Slot<Element> array(std::size_t count, const Shares& shares) {
        static_assert(std::is_trivially_destructible_v<Element> && alignof(Element) <= alignment);
        const std::size_t start = (size_ + alignment - 1) / alignment * alignment;
        add_piece(1, start - size_, {});
        add_piece(sizeof(Element), count, shares);
        return {start, count};
    }

    /// One element right behind what is there, of any size: for records of several lengths. Returns where it
    /// starts.
    std::size_t append(std::size_t bytes, const Shares& shares) {
        const std::size_t start = size_;
        add_piece(bytes, 1, shares);
        return start;
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Ledger ledger() const {
        Ledger ledger;
        for (const Piece& piece : pieces_) piece.add_to(ledger);
        return ledger;
    }
    /// In memory order, without gaps; as they lie in a block that starts at `base`.
    [[nodiscard]] std::vector<Piece> pieces(const std::byte* base) const {
        std::vector<Piece> placed = pieces_;
        for (Piece& piece : placed) {
            piece.at = base;
            base += piece.bytes();
        }
        return placed;
    }

  private:
    void add_piece(std::size_t stride, std::size_t count, const Shares& shares) {
        size_ += stride * count;
        if (count == 0) return;
        if (!pieces_.empty() && pieces_.back().stride == stride && pieces_.back().shares == shares) {
            pieces_.back().count += count;
        } else {
            pieces_.push_back({nullptr, stride, count, shares});
        }
    }

    std::size_t size_ = 0;
    std::vector<Piece> pieces_;  // not placed yet
};

/// Shared: tables that differ only in their loader are views of one block. Nothing is written to memory that
/// nobody asked to write: a page of planes that a lazy table never makes is never there.
class Block {
  public:
    Block() = default;
    explicit Block(BlockPlan plan) : held_(std::make_shared<const Held>(std::move(plan))) {}

    /// Begins the array: its elements are there, without a value yet, and no memory is written for it.
    template <class Element>
    [[nodiscard]] Element* start(Slot<Element> slot) const {
        Element* const to = at(slot);
        std::uninitialized_default_construct_n(to, slot.count);
        return to;
    }
    /// An array that was begun.
    template <class Element>
    [[nodiscard]] Element* at(Slot<Element> slot) const {
        return reinterpret_cast<Element*>(held_->memory + slot.offset);
    }
    /// Builds every element of an array in place: element i is make(i).
    template <class Element, class Make>
    Element* fill(Slot<Element> slot, Make make) const {
        Element* const to = at(slot);
        for (std::size_t i = 0; i < slot.count; ++i)
            new (to + i) Element(make(static_cast<std::uint32_t>(i)));
        return to;
    }
    [[nodiscard]] std::byte* base() const { return held_->memory; }
    [[nodiscard]] Ledger ledger() const { return held_ ? held_->plan.ledger() : Ledger{}; }
    [[nodiscard]] std::vector<Piece> pieces() const { return held_->plan.pieces(held_->memory); }

  private:
    struct Held {
        BlockPlan plan;
        std::pmr::memory_resource& resource = table_memory();
        std::byte* memory;

        explicit Held(BlockPlan planned)
            : plan(std::move(planned)),
              memory(static_cast<std::byte*>(resource.allocate(plan.size(), BlockPlan::alignment))) {}
        ~Held() { resource.deallocate(memory, plan.size(), BlockPlan::alignment); }
        Held(const Held&) = delete;
        Held& operator=(const Held&) = delete;
    };

    std::shared_ptr<const Held> held_;
};

}  // namespace edgewise
