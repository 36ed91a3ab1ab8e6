// SPDX-License-Identifier: MIT
//
// One table, one aligned block of memory. A layout first plans its arrays, saying what each byte of an
// element is for; then the block is allocated once and the arrays are placed at fixed offsets. So the ledger
// is what was really allocated, and an address inside the block is the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <new>
#include <type_traits>

#include "edgewise/table/ledger.hpp"

namespace edgewise {

/// How many bytes of one array element serve which component; the rest of the element is padding.
struct Share {
    Component component;
    std::size_t bytes;
};

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
    Slot<Element> array(std::size_t count, std::initializer_list<Share> shares) {
        static_assert(std::is_trivially_destructible_v<Element> && alignof(Element) <= alignment);
        const std::size_t start = (size_ + alignment - 1) / alignment * alignment;
        ledger_[Component::padding] += start - size_;
        std::size_t spoken_for = 0;
        for (const Share& share : shares) {
            ledger_[share.component] += share.bytes * count;
            spoken_for += share.bytes;
        }
        ledger_[Component::padding] += (sizeof(Element) - spoken_for) * count;
        size_ = start + sizeof(Element) * count;
        return {start, count};
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] const Ledger& ledger() const { return ledger_; }

  private:
    std::size_t size_ = 0;
    Ledger ledger_;
};

/// Shared: tables that differ only in their loader are views of one block.
class Block {
  public:
    Block() = default;
    explicit Block(const BlockPlan& plan) : ledger_(plan.ledger()) {
        const std::align_val_t alignment{BlockPlan::alignment};
        auto* raw = static_cast<std::byte*>(::operator new(plan.size(), alignment));
        memory_ = std::shared_ptr<std::byte>(raw, [=](std::byte* p) { ::operator delete(p, alignment); });
        std::memset(raw, 0, plan.size());
    }

    template <class Element>
    [[nodiscard]] Element* at(Slot<Element> slot) const {
        return reinterpret_cast<Element*>(memory_.get() + slot.offset);
    }
    /// Builds every element of an array in place: element i is make(i).
    template <class Element, class Make>
    const Element* fill(Slot<Element> slot, Make make) const {
        Element* const to = at(slot);
        for (std::size_t i = 0; i < slot.count; ++i)
            new (to + i) Element(make(static_cast<std::uint32_t>(i)));
        return to;
    }
    [[nodiscard]] const std::byte* base() const { return memory_.get(); }
    [[nodiscard]] const Ledger& ledger() const { return ledger_; }

  private:
    std::shared_ptr<std::byte> memory_;
    Ledger ledger_;
};

}  // namespace edgewise
