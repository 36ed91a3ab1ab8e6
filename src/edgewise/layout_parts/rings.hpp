// SPDX-License-Identifier: MIT
//
// The rings of a body as compressed rows of 32-bit indices, for layouts without rings of their own:
// neighbours of a vertex, edges around a vertex, edges around a face. An edge entry is twice the edge plus
// one when flipped, like the Polyhedron's half-edges, for both kinds of ring. RingsAt writes and reads them
// at any place; Rings are arrays of their own.
#pragma once

#include <cassert>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/block.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/loader.hpp"
#include "edgewise/table/needs.hpp"
#include "edgewise/table/ring.hpp"

namespace edgewise {

/// Places is the derived class, and gives the places of the numbers:
///
///     Index& vertex_offset_at(Index v) const;  // where the rows of a vertex start; one more at the end
///     Index& neighbour_at(Index at) const;
///     Index& vertex_ring_at(Index at) const;
///     Index& face_offset_at(Index f) const;    // likewise of a face
///     Index& face_ring_at(Index at) const;
template <class Places>
struct RingsAt {
    void fill(const Polyhedron& body, Parts parts) const {
        assert(body.vertex_offset.size() == body.vertex_count() + 1);
        const bool features = parts == Parts::features;
        for (Index v = 0; v <= body.vertex_count(); ++v) places().vertex_offset_at(v) = body.vertex_offset[v];
        for (Index at = 0; at < body.vertex_ring.size(); ++at) {
            places().neighbour_at(at) = body.head(body.vertex_ring[at]);
            if (features) places().vertex_ring_at(at) = body.vertex_ring[at];
        }
        if (!features) return;
        for (Index f = 0; f <= body.face_count(); ++f) places().face_offset_at(f) = body.face_offset[f];
        for (Index at = 0; at < body.face_ring.size(); ++at) places().face_ring_at(at) = body.face_ring[at];
    }

    template <class Loader>
    [[nodiscard]] auto neighbours(const Loader& loader, Index v) const {
        const Places& at = places();
        return rows(loader, at.vertex_offset_at(v), at.vertex_offset_at(v + 1), Field::vertex_ring,
                    [&at, &loader](Index i) { return loader.load(at.neighbour_at(i), Field::neighbour); });
    }
    template <class Loader>
    [[nodiscard]] auto ring_of_vertex(const Loader& loader, Index v) const {
        const Places& at = places();
        return rows(loader, at.vertex_offset_at(v), at.vertex_offset_at(v + 1), Field::vertex_ring,
                    [&at, &loader](Index i) {
                        return decode(loader.load(at.vertex_ring_at(i), Field::vertex_ring));
                    });
    }
    template <class Loader>
    [[nodiscard]] auto ring_of_face(const Loader& loader, Index f) const {
        const Places& at = places();
        return rows(
            loader, at.face_offset_at(f), at.face_offset_at(f + 1), Field::face_ring,
            [&at, &loader](Index i) { return decode(loader.load(at.face_ring_at(i), Field::face_ring)); });
    }

  private:
    [[nodiscard]] const Places& places() const { return static_cast<const Places&>(*this); }
    static RingEdge<Index> decode(Index half_edge) { return {half_edge >> 1, (half_edge & 1) != 0}; }

    template <class Loader, class Reader>
    static auto rows(const Loader& loader, const Index& from, const Index& to, Field field, Reader reader) {
        const Index first = loader.load(from, field);
        const Index last = loader.load(to, field);
        return IndexedRing(first, last, reader);
    }
};

struct Rings : RingsAt<Rings> {
    Index* vertex_offset = nullptr;
    Index* neighbour = nullptr;
    Index* vertex_ring = nullptr;
    Index* face_offset = nullptr;
    Index* face_ring = nullptr;

    /// Adds the arrays; those of edges and faces are empty in a table for support points.
    void place(BlockPlan& plan, const BodyFacts& n) {
        const Shares topology = {{Component::topology, sizeof(Index)}};
        const bool features = n.parts == Parts::features;
        plan.array(vertex_offset, n.vertex_count + 1, topology);
        plan.array(neighbour, n.neighbour_count, topology);
        plan.array(vertex_ring, features ? n.neighbour_count : 0, topology);
        plan.array(face_offset, features ? n.face_count + 1 : 0, topology);
        plan.array(face_ring, n.face_ring_count(), topology);
    }

    [[nodiscard]] Index& vertex_offset_at(Index v) const { return vertex_offset[v]; }
    [[nodiscard]] Index& neighbour_at(Index at) const { return neighbour[at]; }
    [[nodiscard]] Index& vertex_ring_at(Index at) const { return vertex_ring[at]; }
    [[nodiscard]] Index& face_offset_at(Index f) const { return face_offset[f]; }
    [[nodiscard]] Index& face_ring_at(Index at) const { return face_ring[at]; }
};

}  // namespace edgewise
