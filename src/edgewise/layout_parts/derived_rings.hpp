// SPDX-License-Identifier: MIT
//
// The topology of a table that stores no feature: neighbour rings are all there is of it, and every edge and
// face is found from them when it is asked for.
//
// An edge is its two vertices and where one stands in the other's ring; a face is its first half-edge.
#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <optional>

#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/layout_parts/derived_walks.hpp"
#include "edgewise/layout_parts/narrow_rings.hpp"
#include "edgewise/table/feature_name.hpp"

namespace edgewise {

/// RingPlaces: where rings are in the block, by place(plan, facts) and in(base), whose result reads them.
template <Precision P, class Loader, class RingPlaces = NarrowRingPlaces>
class DerivedRings : public BlockTable<P, Loader, typename P::Compute> {
    using Base = BlockTable<P, Loader, typename P::Compute>;

  public:
    using typename Base::Vertex;
    using Edge = DerivedEdge;
    using Face = DerivedFace;

    static constexpr Face no_face = {0xffffffff, 0xffffffff};

    [[nodiscard]] auto neighbours(Vertex v) const {
        assert(v < facts_.vertex_count);
        return IndexedRing(rings().first(loader_, v), rings().last(loader_, v),
                           [this](Index at) { return rings().neighbour(loader_, at); });
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return IndexedRing(rings().first(loader_, v), rings().last(loader_, v),
                           [this, v](Index at) { return edge_at(v, at); });
    }

    [[nodiscard]] Vertex tail(const Edge& e) const { return e.tail; }
    [[nodiscard]] Vertex head(const Edge& e) const { return e.head; }
    [[nodiscard]] Face left(const Edge& e) const {
        return facts_.face_count == 0 ? no_face : face_of(from_tail(e));
    }
    [[nodiscard]] Face right(const Edge& e) const {
        return facts_.face_count == 0 ? no_face : face_of(from_head(e));
    }

    [[nodiscard]] auto ring_of_face(const Face& f) const {
        return around(f, [this](const HalfEdgeAt& h) { return edge_at(h.vertex, h.at); });
    }
    [[nodiscard]] auto all_faces() const {
        const Index vertices = facts_.face_count == 0 ? 0 : facts_.vertex_count;
        const auto from = [this, vertices](const HalfEdgeAt& start) {
            return next_half_edge(
                start, vertices, [this](Index v) { return rings().last(loader_, v); },
                [this](const HalfEdgeAt& h) { return face_of(h) == h; });
        };
        const auto after = [from](const Face& f) { return from({f.vertex, f.at + 1}); };
        return Chain(
            from({0, 0}), Face{vertices, 0}, [](const Face& f) { return f; }, after);
    }

    /// An edge's number is that of its half-edge in whose ring it was found, a face's that of its first.
    [[nodiscard]] std::uint32_t edge_name(const Edge& e) const {
        return face_name({e.from_head ? e.head : e.tail, e.at});
    }
    [[nodiscard]] std::uint32_t face_name(const Face& f) const {
        const int bits = place_bits();
        const Index place = f.at - rings().first(loader_, f.vertex);
        return bits >= 0 && place >> bits == 0 ? f.vertex << bits | place : by_place | f.at;
    }
    [[nodiscard]] std::optional<Edge> edge_named(std::uint32_t name) const {
        const auto h = face_named(name);
        return h ? std::optional(edge_at(h->vertex, h->at).edge) : std::nullopt;
    }
    [[nodiscard]] std::optional<Face> face_named(std::uint32_t name) const {
        if (facts_.parts == Parts::support) return std::nullopt;
        if (name & by_place) return at_place(name & ~by_place);
        const int bits = place_bits();
        if (bits < 0 || name >> bits >= facts_.vertex_count) return std::nullopt;
        const Index v = name >> bits;
        const Index at = rings().first(loader_, v) + (name & ((1U << bits) - 1));
        return at < rings().last(loader_, v) ? std::optional(HalfEdgeAt{v, at}) : std::nullopt;
    }

  protected:
    using Base::block_;
    using Base::facts_;
    using Base::loader_;
    RingPlaces ring_places_;

    template <Precision, class, class>
    friend class DerivedRings;

    DerivedRings(const Polyhedron& body, Parts parts, Loader loader) : Base(body, parts, loader) {}
    template <class OtherLoader>
    DerivedRings(const DerivedRings<P, OtherLoader, RingPlaces>& other, Loader loader)
        : Base(other, loader), ring_places_(other.ring_places_) {}

    /// Half-edges of a face in order, from its first, each turned into an item.
    template <class Item>
    [[nodiscard]] auto around(const Face& f, Item item) const {
        using Place = DerivedRingPlace;
        const auto after = [this](const Place& place) { return Place{next(place.at), true}; };
        return Chain(
            Place{f, false}, Place{f, true}, [item](const Place& place) { return item(place.at); }, after);
    }

    [[nodiscard]] RingEdge<Edge> edge_at(Vertex v, Index at) const {
        const Index other = rings().neighbour(loader_, at);
        if (v < other) return {{v, other, at, false}, false};
        return {{other, v, at, true}, true};
    }
    [[nodiscard]] HalfEdgeAt from_tail(const Edge& e) const {
        assert(e.tail < e.head && e.at < facts_.neighbour_count);
        return {e.tail, e.from_head ? rings().find(loader_, e.tail, e.head) : e.at};
    }
    [[nodiscard]] HalfEdgeAt from_head(const Edge& e) const {
        return {e.head, e.from_head ? e.at : rings().find(loader_, e.head, e.tail)};
    }

    /// The next half-edge around the face on the left: at its far end, clockwise from where it came.
    [[nodiscard]] HalfEdgeAt next(const HalfEdgeAt& h) const {
        const Index to = rings().neighbour(loader_, h.at);
        return {to, rings().before(loader_, to, rings().find(loader_, to, h.vertex))};
    }

    /// The face on the left of a half-edge: its smallest half-edge, as in the body.
    [[nodiscard]] Face face_of(const HalfEdgeAt& h) const {
        return first_of_face(
            h, [this](const HalfEdgeAt& at) { return rings().neighbour(loader_, at.at); },
            [this](const HalfEdgeAt& at) { return next(at); });
    }

    [[nodiscard]] auto rings() const { return ring_places_.in(block_.base()); }

  private:
    /// Set in the number of a half-edge whose vertex and place in its ring do not fit: its place among all of
    /// them follows, and its vertex is searched for.
    static constexpr std::uint32_t by_place = 1U << (feature_name_bits - 1);
    static_assert(2 * most_edges < by_place, "a half-edge's place needs bits of its own");

    /// What a vertex leaves of a number for the place in its ring.
    [[nodiscard]] int place_bits() const {
        return feature_name_bits - 1 - static_cast<int>(std::bit_width(facts_.vertex_count - 1));
    }

    [[nodiscard]] std::optional<HalfEdgeAt> at_place(Index at) const {
        if (at >= facts_.neighbour_count) return std::nullopt;
        Index low = 0, high = facts_.vertex_count;  // whose rings begin there or before, and after
        while (high - low > 1) {
            const Index middle = low + (high - low) / 2;
            (rings().first(loader_, middle) <= at ? low : high) = middle;
        }
        return HalfEdgeAt{low, at};
    }
};

}  // namespace edgewise
