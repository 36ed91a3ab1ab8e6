// SPDX-License-Identifier: MIT
//
// Edges and rings of a table of half-edges. Edge e has the half-edges 2e, tail to head, and 2e + 1, as in the
// canonical body. The table defines how half-edges are stored, each number read through its loader:
//
//     Index next(h), before(h), twin(h), origin(h), face_of(h)     around the face on the left; no_face
//     Index leaving(v), first_of(f)                                the first half-edge of a ring
//
// The next half-edge counter-clockwise around a vertex is the twin of the half-edge before.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

#include "edgewise/layout_parts/block_table.hpp"

namespace edgewise {

/// Place in a ring. `under_way`: back at the first half-edge, the ring is done.
struct HalfEdgePlace {
    Index half_edge;
    bool under_way;
    [[nodiscard]] bool operator==(const HalfEdgePlace&) const = default;
};

/// Own: the layout. Places: as in PlacedTable.
template <class Own, class Places, Precision P, class Loader>
class HalfEdgeTable : public WithNumberedFeatures<PlacedTable<Places, P, Loader>> {
    using Base = WithNumberedFeatures<PlacedTable<Places, P, Loader>>;

  public:
    using typename Base::Edge, typename Base::Face, typename Base::Vertex;

    using Base::Base;

    [[nodiscard]] Vertex tail(Edge e) const { return own().origin(2 * e); }
    [[nodiscard]] Vertex head(Edge e) const { return own().origin(2 * e + 1); }
    [[nodiscard]] Face left(Edge e) const { return own().face_of(2 * e); }
    [[nodiscard]] Face right(Edge e) const { return own().face_of(2 * e + 1); }

    [[nodiscard]] auto neighbours(Vertex v) const {
        return around_vertex(v, [this](Index h) { return own().origin(own().twin(h)); });
    }
    [[nodiscard]] auto ring_of_vertex(Vertex v) const { return around_vertex(v, ring_edge); }
    [[nodiscard]] auto ring_of_face(Face f) const {
        assert(f < facts_.face_count);
        return ring({own().first_of(f), false}, ring_edge, [this](Index h) { return own().next(h); });
    }

  protected:
    using Base::facts_;

    static RingEdge<Edge> ring_edge(Index h) { return {h >> 1, (h & 1) != 0}; }

    /// Returns for each half-edge of the body the next one around its face, or around the edge of a segment.
    [[nodiscard]] static std::vector<HalfEdge> successors(const Polyhedron& body) {
        std::vector<HalfEdge> next(2 * body.edge_count());
        for (HalfEdge h = 0; h < next.size(); ++h) next[h] = h ^ 1;
        for (Index f = 0; f < body.face_count(); ++f) {
            const auto ring = body.ring_of_face(f);
            for (std::size_t i = 0; i < ring.size(); ++i) next[ring[i]] = ring[(i + 1) % ring.size()];
        }
        return next;
    }

  private:
    [[nodiscard]] const Own& own() const { return static_cast<const Own&>(*this); }

    template <class Item, class Next>
    [[nodiscard]] static auto ring(const HalfEdgePlace& first, Item item, Next next) {
        using Place = HalfEdgePlace;
        return Chain(
            first, Place{first.half_edge, true}, [item](const Place& at) { return item(at.half_edge); },
            [next](const Place& at) {
                return Place{next(at.half_edge), true};
            });
    }
    /// Range around a vertex; empty around a point.
    template <class Item>
    [[nodiscard]] auto around_vertex(Vertex v, Item item) const {
        assert(v < facts_.vertex_count);
        const bool any = facts_.edge_count() > 0;
        return ring({any ? own().leaving(v) : 0, !any}, item,
                    [this](Index h) { return own().twin(own().before(h)); });
    }
};

}  // namespace edgewise
