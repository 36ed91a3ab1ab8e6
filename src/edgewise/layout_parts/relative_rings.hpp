// SPDX-License-Identifier: MIT
//
// Neighbour rings of one byte an entry in bodies of more than 256 vertices: the difference between the
// neighbour's number and the vertex's own. Where vertices are numbered for it (geometry/bandwidth_order.hpp)
// all differences fit up to some 3 800 vertices. One that does not, as to a vertex of very many neighbours,
// stands in a list of its own, searched by halves. Where plain indices are shorter, because nearly nothing
// fits or a byte counts all vertices, the rings are those of narrow_rings.hpp.
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "edgewise/layout_parts/narrow_rings.hpp"

namespace edgewise {

/// The byte that says that a difference stands in the list, and the largest that fits.
inline constexpr std::int8_t far_neighbour = -128;
inline constexpr std::int64_t most_difference = 127;

[[nodiscard]] inline std::int64_t difference(Index from, Index to) {
    return static_cast<std::int64_t>(to) - static_cast<std::int64_t>(from);
}
[[nodiscard]] inline bool fits_a_byte(std::int64_t difference) {
    return std::abs(difference) <= most_difference;
}

/// As they are read. Positions are those of narrow_rings.hpp.
class RelativeRings : public RingSteps<RelativeRings> {
  public:
    /// Entries of rings that are in bytes; else as `plain` has them.
    struct Far {
        NarrowArray position, neighbour;
        Index count;
    };

    RelativeRings(NarrowArray offset, std::int8_t* entry, const Far& far)
        : offset_(offset), plain_(nullptr, 1), entry_(entry), far_(far) {}
    RelativeRings(NarrowArray offset, NarrowArray plain)
        : offset_(offset), plain_(plain), far_{{nullptr, 1}, {nullptr, 1}, 0} {}

    void fill(const Polyhedron& body) {
        offset_.fill(body.vertex_offset.size(), [&](Index i) { return body.vertex_offset[i]; });
        if (entry_)
            fill_entries(body);
        else
            plain_.fill(body.vertex_ring.size(), [&](Index i) { return body.head(body.vertex_ring[i]); });
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
    [[nodiscard]] Index neighbour(const Loader& loader, Index v, Index at) const {
        if (!entry_) return plain_.read(loader, at, Field::neighbour);
        const std::int8_t step = loader.load(entry_[at], Field::neighbour);
        if (step == far_neighbour) [[unlikely]]
            return far_at(loader, at);
        return v + static_cast<Index>(std::int32_t{step});
    }

  private:
    void fill_entries(const Polyhedron& body) {
        Index next = 0;
        for (Index at = 0; at < body.vertex_ring.size(); ++at) {
            const Index to = body.head(body.vertex_ring[at]);
            const std::int64_t step = difference(body.tail(body.vertex_ring[at]), to);
            const bool fits = fits_a_byte(step);
            entry_[at] = fits ? static_cast<std::int8_t>(step) : far_neighbour;
            if (fits) continue;
            assert(next < far_.count);
            far_.position.write(next, at);
            far_.neighbour.write(next++, to);
        }
        assert(next == far_.count);
    }

    template <class Loader>
    [[nodiscard]] [[gnu::noinline]] Index far_at(const Loader& loader, Index at) const {
        Index low = 0, high = far_.count;  // the wanted one stands from low on, before high
        while (high - low > 1) {
            const Index middle = low + (high - low) / 2;
            (far_.position.read(loader, middle, Field::neighbour) <= at ? low : high) = middle;
        }
        return far_.neighbour.read(loader, low, Field::neighbour);
    }

    NarrowArray offset_, plain_;
    std::int8_t* entry_ = nullptr;  ///< none: plain
    Far far_;
};

/// What a table keeps of its rings.
class RelativeRingPlaces {
  public:
    /// Chooses the shorter of both forms.
    void prepare(const Polyhedron& body) {
        std::size_t far = 0;
        for (const HalfEdge h : body.vertex_ring)
            far += fits_a_byte(difference(body.tail(h), body.head(h))) ? 0 : 1;
        const std::size_t entries = body.vertex_ring.size(), plain = narrow_width(body.vertex_count() - 1);
        is_relative_ = entries + far * (narrow_width(entries) + plain) < entries * plain;
        far_count_ = is_relative_ ? static_cast<std::uint32_t>(far) : 0;
    }

    void place(BlockPlan& plan, const BodyFacts& n) {
        const NarrowPlace entry(plan, n.neighbour_count, is_relative_ ? 0 : n.vertex_count - 1);
        entry_width_ = entry.width;
        entry_at_ = entry.at;
        const NarrowPlace offset(plan, n.vertex_count + 1, n.neighbour_count);
        offset_width_ = offset.width;
        offset_at_ = offset.at;
        const NarrowPlace position(plan, far_count_, n.neighbour_count),
            far(plan, far_count_, n.vertex_count - 1);
        position_at_ = position.at;
        far_at_ = far.at;
        far_width_ = far.width;
    }
    [[nodiscard]] RelativeRings in(std::byte* base) const {
        const NarrowArray offset(base + offset_at_, offset_width_);
        if (!is_relative_) return {offset, {base + entry_at_, entry_width_}};
        return {offset,
                reinterpret_cast<std::int8_t*>(base + entry_at_),
                {{base + position_at_, offset_width_}, {base + far_at_, far_width_}, far_count_}};
    }

  private:
    bool is_relative_ = false;
    std::uint8_t offset_width_ = 1, entry_width_ = 1, far_width_ = 1;
    std::uint32_t far_count_ = 0;
    std::uint32_t offset_at_ = 0, entry_at_ = 0, position_at_ = 0, far_at_ = 0;
};

}  // namespace edgewise
