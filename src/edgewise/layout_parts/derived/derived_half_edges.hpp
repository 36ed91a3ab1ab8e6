// SPDX-License-Identifier: MIT
//
// Half-edges of a table that stores no feature: a vertex and a place in its ring each. Finds the next one
// around a face, the face corner next to an edge, and the place of the same edge in the other end's ring.
#pragma once

#include <algorithm>
#include <cassert>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/layout_parts/narrow_rings.hpp"

namespace edgewise {

/// `at` is the head's place in the ring of the tail, or, seen from the head, the tail's place in its ring; or
/// `nowhere`: then it is searched when it is needed.
struct DerivedEdge {
    static constexpr Index nowhere = 0xffffffff;

    Index tail, head, at;
    bool from_head;

    [[nodiscard]] bool operator==(const DerivedEdge& other) const {
        return tail == other.tail && head == other.head;
    }
};

/// A half-edge: from `vertex` to the neighbour at this place of all rings.
struct HalfEdgeAt {
    Index vertex, at;
    [[nodiscard]] bool operator==(const HalfEdgeAt&) const = default;
};

/// A face, by the first half-edge of its ring.
using DerivedFace = HalfEdgeAt;

/// A side of a face, from one corner to the next counter-clockwise, and its place in the ring of one of them.
struct DerivedSide {
    HalfEdgeAt known;
    Index from, to;

    [[nodiscard]] DerivedEdge edge() const {
        return {std::min(from, to), std::max(from, to), known.at, known.vertex == std::max(from, to)};
    }
};

/// The first wanted half-edge from here on, at vertices below `vertices`; last(v) is the end of v's ring, and
/// the places of all rings follow each other. If there is none: vertex `vertices`, place 0.
template <class Last, class Wanted>
[[nodiscard]] HalfEdgeAt next_half_edge(HalfEdgeAt h, Index vertices, Last last, Wanted wanted) {
    for (; h.vertex < vertices; ++h.vertex) {
        for (; h.at < last(h.vertex); ++h.at) {
            if (wanted(h)) return h;
        }
    }
    return {vertices, 0};
}

/// A step on the way around a face: back at its first half-edge, the ring is done.
struct DerivedRingPlace {
    HalfEdgeAt at;
    bool under_way;
    [[nodiscard]] bool operator==(const DerivedRingPlace&) const = default;
};

/// RingPlaces: places of the rings in the block, by place(plan, facts) and in(base), which returns a reader.
template <Precision P, class Loader, class RingPlaces = NarrowRingPlaces>
class DerivedHalfEdges : public BlockTable<P, Loader, typename P::Compute> {
    using Base = BlockTable<P, Loader, typename P::Compute>;

  public:
    using typename Base::Vertex;
    using Edge = DerivedEdge;
    using Face = DerivedFace;

  protected:
    using Base::block_, Base::facts_, Base::loader_;
    RingPlaces ring_places_;

    template <Precision, class, class>
    friend class DerivedHalfEdges;

    DerivedHalfEdges(const Polyhedron& body, Parts parts, Loader loader) : Base(body, parts, loader) {}
    template <class OtherLoader>
    DerivedHalfEdges(const DerivedHalfEdges<P, OtherLoader, RingPlaces>& other, Loader loader)
        : Base(other, loader), ring_places_(other.ring_places_) {}

    [[nodiscard]] auto rings() const { return ring_places_.in(block_.base()); }

    /// Range of the half-edges of a face in order, from its first, each turned into an item.
    template <class Item>
    [[nodiscard]] auto around(const Face& f, Item item) const {
        using Place = DerivedRingPlace;
        const auto after = [this](const Place& place) { return Place{next(place.at), true}; };
        return Chain(
            Place{f, false}, Place{f, true}, [item](const Place& place) { return item(place.at); }, after);
    }

    [[nodiscard]] RingEdge<Edge> edge_at(Vertex v, Index at) const {
        const Index other = rings().neighbour(loader_, v, at);
        if (v < other) return {{v, other, at, false}, false};
        return {{other, v, at, true}, true};
    }
    [[nodiscard]] HalfEdgeAt from_tail(const Edge& e) const {
        assert(e.tail < e.head);
        const bool known = !e.from_head && e.at != Edge::nowhere;
        return {e.tail, known ? e.at : rings().find(loader_, e.tail, e.head)};
    }
    [[nodiscard]] HalfEdgeAt from_head(const Edge& e) const {
        return {e.head, e.from_head ? e.at : rings().find(loader_, e.head, e.tail)};
    }
    /// The half-edge from the end that knows the edge's place in its ring.
    [[nodiscard]] HalfEdgeAt half_edge_of(const Edge& e) const {
        return e.from_head ? HalfEdgeAt{e.head, e.at} : from_tail(e);
    }
    [[nodiscard]] static Edge edge_somewhere(Vertex v, Vertex other) {
        return {std::min(v, other), std::max(v, other), Edge::nowhere, false};
    }

    /// True if all faces are triangles. Then the third corner of a face is the same from either end of an
    /// edge, and no ring is searched for it.
    [[nodiscard]] bool all_triangles() const { return 3 * facts_.face_count == facts_.neighbour_count; }

    /// The third corner of the face on this side. The tail's ring gives it, or, where all faces are
    /// triangles, the ring of the end that knows the edge's place.
    [[nodiscard]] Index third_corner(const Edge& e, Side side) const {
        const bool from_head = e.from_head && all_triangles();
        const HalfEdgeAt h = from_head ? HalfEdgeAt{e.head, e.at} : from_tail(e);
        const Index at = (side == Side::left) == from_head ? rings().before(loader_, h.vertex, h.at)
                                                           : rings().after(loader_, h.vertex, h.at);
        return rings().neighbour(loader_, h.vertex, at);
    }

    /// The corners of a triangle, counter-clockwise from the start of one of its half-edges, and the place of
    /// the third in the ring of the first.
    struct Corners {
        Index first, second, third, third_at;
    };
    [[nodiscard]] Corners corners_of(const HalfEdgeAt& h) const {
        const Index third_at = rings().after(loader_, h.vertex, h.at);
        return {h.vertex, rings().neighbour(loader_, h.vertex, h.at),
                rings().neighbour(loader_, h.vertex, third_at), third_at};
    }

    /// Calls visit(side) around a face, from its first half-edge or any other, until it returns false. The
    /// ring of the first corner knows the last one: a triangle takes one search.
    template <class Visit>
    void visit_sides(const HalfEdgeAt& first, Visit visit) const {
        const Corners c = corners_of(first);
        HalfEdgeAt h = first;
        for (Index to = c.second; visit(DerivedSide{h, h.vertex, to});) {
            if (to == c.third) {
                visit(DerivedSide{{c.first, c.third_at}, c.third, c.first});
                return;
            }
            h = next(h);
            to = rings().neighbour(loader_, h.vertex, h.at);
        }
    }

    /// The next half-edge around the face on the left: at its far end, clockwise from the way back.
    [[nodiscard]] HalfEdgeAt next(const HalfEdgeAt& h) const {
        const Index to = rings().neighbour(loader_, h.vertex, h.at);
        return {to, rings().before(loader_, to, rings().find(loader_, to, h.vertex))};
    }
};

}  // namespace edgewise
