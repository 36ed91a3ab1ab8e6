// SPDX-License-Identifier: MIT
//
// A table that derives all features, as DerivedTable does, with vertices numbered so that neighbours are one
// byte away, also in bodies of more than 256 vertices: a ring's entry is the difference between the
// neighbour's number and the vertex's own. Where vertices are numbered for it (geometry/vertex_order.hpp) all
// differences fit up to some 3 800 vertices. A difference that does not fit, as to a vertex of very many
// neighbours, is in a list of its own, with binary search. Where plain indices are shorter, because nearly
// nothing fits or a byte counts all vertices, the rings are those of narrow_rings.hpp: the table holds a body
// in another order as well, in more bytes.
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "edgewise/geometry/vertex_order.hpp"
#include "edgewise/layout_parts/derived/derived_table.hpp"
#include "edgewise/layout_parts/input_order.hpp"
#include "edgewise/layout_parts/narrow_rings.hpp"

namespace edgewise {

/// The byte that marks a difference in the list, and the largest difference that fits.
inline constexpr std::int8_t far_neighbour = -128;
inline constexpr std::int64_t most_difference = 127;

[[nodiscard]] inline std::int64_t difference(Index from, Index to) {
    return static_cast<std::int64_t>(to) - static_cast<std::int64_t>(from);
}
[[nodiscard]] inline bool fits_a_byte(std::int64_t difference) {
    return std::abs(difference) <= most_difference;
}

/// Places of a table's rings, in bytes from its block's start. Positions are those of narrow_rings.hpp.
struct RelativeRingBlock {
    bool is_relative = false;  ///< else entries are plain indices
    std::uint8_t offset_width = 1, entry_width = 1, far_width = 1;
    std::uint32_t offset_at = 0, entry_at = 0;
    /// Neighbours with differences that do not fit: their positions, their indices, and their number.
    std::uint32_t position_at = 0, far_at = 0, far_count = 0;

    [[nodiscard]] NarrowArray offsets(std::byte* base) const { return {base + offset_at, offset_width}; }
    [[nodiscard]] NarrowArray plain(std::byte* base) const { return {base + entry_at, entry_width}; }
    [[nodiscard]] std::int8_t* entries(std::byte* base) const {
        return reinterpret_cast<std::int8_t*>(base + entry_at);
    }
    [[nodiscard]] NarrowArray far_positions(std::byte* base) const {
        return {base + position_at, offset_width};
    }
    [[nodiscard]] NarrowArray far_neighbours(std::byte* base) const { return {base + far_at, far_width}; }

    /// Reads a neighbour from the list. Not inlined, and by value of two pointers: the code for nearly all
    /// neighbours stays short.
    template <class Loader>
    [[nodiscard]] [[gnu::noinline]] static Index far_neighbour_at(const RelativeRingBlock& in,
                                                                  const Loader& loader, std::byte* base,
                                                                  Index at) {
        Index low = 0, high = in.far_count;  // the wanted position is in [low, high)
        while (high - low > 1) {
            const Index middle = low + (high - low) / 2;
            (in.far_positions(base).read(loader, middle, Field::neighbour) <= at ? low : high) = middle;
        }
        return in.far_neighbours(base).read(loader, low, Field::neighbour);
    }
};

/// Reads rings of either form.
class RelativeRings : public RingSteps<RelativeRings> {
  public:
    RelativeRings(const RelativeRingBlock& in, std::byte* base) : in_(&in), base_(base) {}

    void fill(const Polyhedron& body) const {
        in_->offsets(base_).fill(body.vertex_offset.size(), [&](Index i) { return body.vertex_offset[i]; });
        if (in_->is_relative)
            fill_entries(body);
        else
            in_->plain(base_).fill(body.vertex_ring.size(),
                                   [&](Index i) { return body.head(body.vertex_ring[i]); });
    }

    template <class Loader>
    [[nodiscard]] Index first(const Loader& loader, Index v) const {
        return in_->offsets(base_).read(loader, v, Field::vertex_ring);
    }
    template <class Loader>
    [[nodiscard]] Index last(const Loader& loader, Index v) const {
        return in_->offsets(base_).read(loader, v + 1, Field::vertex_ring);
    }
    template <class Loader>
    [[nodiscard]] Index neighbour(const Loader& loader, Index v, Index at) const {
        if (!in_->is_relative) return in_->plain(base_).read(loader, at, Field::neighbour);
        const std::int8_t step = loader.load(in_->entries(base_)[at], Field::neighbour);
        if (step == far_neighbour) [[unlikely]]
            return RelativeRingBlock::far_neighbour_at(*in_, loader, base_, at);
        return v + static_cast<Index>(std::int32_t{step});
    }

  private:
    void fill_entries(const Polyhedron& body) const {
        Index next = 0;
        for (Index at = 0; at < body.vertex_ring.size(); ++at) {
            const Index to = body.head(body.vertex_ring[at]);
            const std::int64_t step = difference(body.tail(body.vertex_ring[at]), to);
            const bool fits = fits_a_byte(step);
            in_->entries(base_)[at] = fits ? static_cast<std::int8_t>(step) : far_neighbour;
            if (fits) continue;
            assert(next < in_->far_count);
            in_->far_positions(base_).write(next, at);
            in_->far_neighbours(base_).write(next++, to);
        }
        assert(next == in_->far_count);
    }

    const RelativeRingBlock* in_;
    std::byte* base_;
};

/// The part of a table that holds its rings.
class RelativeRingPlaces {
  public:
    /// Chooses the shorter of the two forms.
    void prepare(const Polyhedron& body) {
        std::size_t far = 0;
        for (const HalfEdge h : body.vertex_ring) far += !fits_a_byte(difference(body.tail(h), body.head(h)));
        const std::size_t entries = body.vertex_ring.size(), plain = narrow_width(body.vertex_count() - 1);
        block_.is_relative = entries + far * (narrow_width(entries) + plain) < entries * plain;
        block_.far_count = block_.is_relative ? static_cast<std::uint32_t>(far) : 0;
    }

    void place(BlockPlan& plan, const BodyFacts& n) {
        const NarrowPlace entry(plan, n.neighbour_count, block_.is_relative ? 0 : n.vertex_count - 1);
        block_.entry_width = entry.width;
        block_.entry_at = entry.at;
        const NarrowPlace offset(plan, n.vertex_count + 1, n.neighbour_count);
        block_.offset_width = offset.width;
        block_.offset_at = offset.at;
        const NarrowPlace position(plan, block_.far_count, n.neighbour_count);
        const NarrowPlace far(plan, block_.far_count, n.vertex_count - 1);
        block_.position_at = position.at;
        block_.far_at = far.at;
        block_.far_width = far.width;
    }
    [[nodiscard]] RelativeRings in(std::byte* base) const { return {block_, base}; }

  private:
    RelativeRingBlock block_;
};

template <class Points, Precision P, class Loader>
class RelativeTable : public DerivedTable<WithInputOrder<Points>, P, Loader, RelativeRingPlaces> {
    using Base = DerivedTable<WithInputOrder<Points>, P, Loader, RelativeRingPlaces>;

  public:
    using typename Base::Vertex;

    /// Order of the bodies that tables are built from (table/stored_body.hpp).
    static constexpr VertexOrder vertex_order = VertexOrder::rcm;

    RelativeTable(const Polyhedron& body, Parts parts, Loader loader = {},
                  InputOrder wanted = InputOrder::left_out)
        : Base(body, parts, loader, WithInputOrder<Points>(body, wanted)) {}
    template <class OtherLoader>
    RelativeTable(const RelativeTable<Points, P, OtherLoader>& other, Loader loader) : Base(other, loader) {}

    [[nodiscard]] bool keeps_input_order() const { return this->points_.keeps_input_order(); }
    /// Index of the vertex in the user's list, for a table that keeps it.
    [[nodiscard]] Index input_index(Vertex v) const {
        return this->points_.input_index(this->loader_, this->block_.base(), v);
    }
};

}  // namespace edgewise
