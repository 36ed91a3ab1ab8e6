// SPDX-License-Identifier: MIT
//
// Neighbour rings in as few bytes as the body's size allows: compressed rows of vertex indices of 8, 16 or 32
// bits, and the start of each row in 8, 16 or 32 bits. From 257 vertices on 16 bits, from 65 537 on 32.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/block.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/loader.hpp"

namespace edgewise {

/// Whole numbers below some limit, each in 1, 2 or 4 bytes. Must not be the first array of its block
/// (Loader::load_narrow).
class NarrowArray {
  public:
    NarrowArray(std::byte* data, std::uint32_t width) : data_(data), width_(width) {}

    /// Writes `count` numbers: make(i) at position i.
    template <class Make>
    void fill(std::size_t count, Make make) {
        for (std::size_t i = 0; i < count; ++i) write(i, make(static_cast<Index>(i)));
    }
    void write(std::size_t i, Index value) {
        assert(width_ == 4 || value >> (8 * width_) == 0);
        if (width_ == 1) data_[i] = static_cast<std::byte>(value);
        if (width_ == 2) reinterpret_cast<std::uint16_t*>(data_)[i] = static_cast<std::uint16_t>(value);
        if (width_ == 4) reinterpret_cast<std::uint32_t*>(data_)[i] = value;
    }

    template <class Loader>
    [[nodiscard]] Index read(const Loader& loader, Index i, Field field) const {
        return loader.load_narrow(data_ + (std::size_t{i} << (width_ >> 1)), width_, field);
    }

  private:
    std::byte* data_;
    std::uint32_t width_;
};

/// Number of bytes for a number up to this one.
[[nodiscard]] inline std::uint8_t narrow_width(std::size_t largest) {
    return largest <= 0xff ? 1 : largest <= 0xffff ? 2 : 4;
}

/// Place of a NarrowArray in a block, without a pointer.
struct NarrowPlace {
    std::uint32_t at = 0;
    std::uint8_t width = 1;

    /// `largest` decides the width.
    NarrowPlace(BlockPlan& plan, std::size_t count, std::size_t largest, Component use = Component::topology)
        : width(narrow_width(largest)) {
        const Shares shares = {{use, width}};
        at = width == 1   ? plan.array_at<std::uint8_t>(count, shares)
             : width == 2 ? plan.array_at<std::uint16_t>(count, shares)
                          : plan.array_at<std::uint32_t>(count, shares);
    }
};

/// Steps within rings with consecutive positions: Rings has first(loader, v), last(loader, v) and
/// neighbour(loader, v, at), the neighbour at a position in the ring of v.
template <class Rings>
class RingSteps {
  public:
    /// Position of `wanted` in the ring of v; it must be there.
    template <class Loader>
    [[nodiscard]] Index find(const Loader& loader, Index v, Index wanted) const {
        Index at = own().first(loader, v);
        while (own().neighbour(loader, v, at) != wanted) {
            ++at;
            assert(at < own().last(Direct(), v));
        }
        return at;
    }

    /// The next position counter-clockwise, and the one before.
    template <class Loader>
    [[nodiscard]] Index after(const Loader& loader, Index v, Index at) const {
        return at + 1 == own().last(loader, v) ? own().first(loader, v) : at + 1;
    }
    template <class Loader>
    [[nodiscard]] Index before(const Loader& loader, Index v, Index at) const {
        return at == own().first(loader, v) ? own().last(loader, v) - 1 : at - 1;
    }

  private:
    [[nodiscard]] const Rings& own() const { return static_cast<const Rings&>(*this); }
};

/// Positions in a ring are counted from the start of all rings.
class NarrowRings : public RingSteps<NarrowRings> {
  public:
    NarrowRings(NarrowArray offset, NarrowArray neighbour) : offset_(offset), neighbour_(neighbour) {}

    void fill(const Polyhedron& body) {
        offset_.fill(body.vertex_offset.size(), [&](Index i) { return body.vertex_offset[i]; });
        neighbour_.fill(body.vertex_ring.size(), [&](Index i) { return body.head(body.vertex_ring[i]); });
    }

    template <class Loader>
    [[nodiscard]] Index first(const Loader& loader, Index v) const {
        return offset_.read(loader, v, Field::vertex_ring);
    }
    template <class Loader>
    [[nodiscard]] Index last(const Loader& loader, Index v) const {
        return offset_.read(loader, v + 1, Field::vertex_ring);
    }
    template <class Loader>
    [[nodiscard]] Index neighbour(const Loader& loader, Index /*v*/, Index at) const {
        return neighbour_.read(loader, at, Field::neighbour);
    }

  private:
    NarrowArray offset_, neighbour_;
};

/// The part of a table that holds its rings.
class NarrowRingPlaces {
  public:
    void place(BlockPlan& plan, const BodyFacts& n) {
        const NarrowPlace offset(plan, n.vertex_count + 1, n.neighbour_count);
        const NarrowPlace neighbour(plan, n.neighbour_count, n.vertex_count - 1);
        offset_width_ = offset.width;
        neighbour_width_ = neighbour.width;
        offset_at_ = offset.at;
        neighbour_at_ = neighbour.at;
    }
    [[nodiscard]] NarrowRings in(std::byte* base) const {
        return {{base + offset_at_, offset_width_}, {base + neighbour_at_, neighbour_width_}};
    }

  private:
    std::uint8_t offset_width_ = 1, neighbour_width_ = 1;
    std::uint32_t offset_at_ = 0, neighbour_at_ = 0;
};

}  // namespace edgewise
