// SPDX-License-Identifier: MIT
//
// The topology of a table that stores no feature: it has only neighbour rings, and finds every edge and face
// from them when it is asked for.
//
// An edge is its two vertices and the place of one in the other's ring; a face is its first half-edge.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <optional>

#include "edgewise/layout_parts/derived/derived_half_edges.hpp"
#include "edgewise/table/feature_handle.hpp"

namespace edgewise {

/// RingPlaces: as in DerivedHalfEdges.
template <Precision P, class Loader, class RingPlaces = NarrowRingPlaces>
class DerivedRings : public DerivedHalfEdges<P, Loader, RingPlaces> {
    using Base = DerivedHalfEdges<P, Loader, RingPlaces>;

  public:
    using typename Base::Edge, typename Base::Face, typename Base::Vertex;
    /// Name of an edge in the ring of a vertex: its place.
    using RingName = Index;

    static constexpr Face no_face = {0xffffffff, 0xffffffff};

    [[nodiscard]] auto neighbours(Vertex v) const {
        assert(v < facts_.vertex_count);
        return IndexedRing(rings().first(loader_, v), rings().last(loader_, v),
                           [this, v](Index at) { return rings().neighbour(loader_, v, at); });
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        return IndexedRing(rings().first(loader_, v), rings().last(loader_, v),
                           [this, v](Index at) { return edge_at(v, at); });
    }

    [[nodiscard]] Edge edge_in_ring(Vertex v, RingName at) const { return edge_at(v, at).edge; }

    [[nodiscard]] Vertex tail(const Edge& e) const { return e.tail; }
    [[nodiscard]] Vertex head(const Edge& e) const { return e.head; }
    [[nodiscard]] Face left(const Edge& e) const { return face_beside(e, Side::left); }
    [[nodiscard]] Face right(const Edge& e) const { return face_beside(e, Side::right); }

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

    /// Number of an edge: that of its half-edge with the known place; of a face: that of its first half-edge.
    [[nodiscard]] std::uint32_t edge_name(const Edge& e) const { return face_name(half_edge_of(e)); }
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
    using Base::all_triangles, Base::around, Base::corners_of, Base::edge_at, Base::facts_, Base::from_head,
        Base::from_tail, Base::half_edge_of, Base::loader_, Base::rings, Base::visit_sides;
    using typename Base::Corners;

    DerivedRings(const Polyhedron& body, Parts parts, Loader loader) : Base(body, parts, loader) {}
    template <class OtherLoader>
    DerivedRings(const DerivedRings<P, OtherLoader, RingPlaces>& other, Loader loader)
        : Base(other, loader) {}

    [[nodiscard]] [[gnu::noinline]] Face face_beside(const Edge& e, Side side) const {
        if (facts_.face_count == 0) return no_face;
        if (!all_triangles()) return face_of(side == Side::left ? from_tail(e) : from_head(e));
        const HalfEdgeAt here = half_edge_of(e);
        if (e.from_head == (side == Side::right)) return face_of(here);
        return face_of({here.vertex, rings().before(loader_, here.vertex, here.at)});
    }

    /// The face on the left of a half-edge, by its smallest half-edge, as in the body.
    [[nodiscard]] Face face_of(const HalfEdgeAt& h) const {
        return all_triangles() ? triangle_of(corners_of(h), h) : polygon_of(h);
    }
    /// The face on the left, for any face. Not inlined, like all ways around a whole face: a run of V-Clip
    /// inlines what it may, and each of their dozens of places would be hundreds of instructions.
    [[nodiscard]] [[gnu::noinline]] Face polygon_of(const HalfEdgeAt& h) const {
        const auto is_before = [](const Edge& a, const Edge& b) {
            return a.tail < b.tail || (a.tail == b.tail && a.head < b.head);
        };
        DerivedSide best{h, Edge::nowhere, Edge::nowhere};
        visit_sides(h, [&](const DerivedSide& side) {
            if (is_before(side.edge(), best.edge())) best = side;
            return true;
        });
        if (best.known.vertex == best.from) return best.known;
        return {best.from, rings().find(loader_, best.from, best.to)};
    }

    [[nodiscard]] Face triangle_of(const Corners& c, const HalfEdgeAt& h) const {
        const Index least = std::min({c.first, c.second, c.third});
        const auto far_end = [&](Index other) { return other == least ? 0xffffffffU : other; };
        const Index least_but_one = std::min({far_end(c.first), far_end(c.second), far_end(c.third)});
        const auto joins = [&](Index a, Index b) {
            return std::min(a, b) == least && std::max(a, b) == least_but_one;
        };
        if (joins(c.first, c.second)) return h;
        const bool second = joins(c.second, c.third);
        const Index from = second ? c.second : c.third, to = second ? c.third : c.first;
        return {from, rings().find(loader_, from, to)};
    }

  private:
    /// Bit that is set in the number of a half-edge if its vertex and its place in the ring do not fit: its
    /// place among all half-edges follows, and its vertex is searched for.
    static constexpr std::uint32_t by_place = 1U << (feature_name_bits - 1);
    static_assert(2 * most_edges < by_place, "a half-edge's place needs bits of its own");

    /// Number of bits that a vertex leaves for the place in its ring.
    [[nodiscard]] int place_bits() const {
        return feature_name_bits - 1 - static_cast<int>(std::bit_width(facts_.vertex_count - 1));
    }

    [[nodiscard]] std::optional<HalfEdgeAt> at_place(Index at) const {
        if (at >= facts_.neighbour_count) return std::nullopt;
        Index low = 0, high = facts_.vertex_count;  // `low`'s ring begins there or before, `high`'s after
        while (high - low > 1) {
            const Index middle = low + (high - low) / 2;
            (rings().first(loader_, middle) <= at ? low : high) = middle;
        }
        return HalfEdgeAt{low, at};
    }
};

}  // namespace edgewise
