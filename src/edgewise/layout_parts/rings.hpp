// SPDX-License-Identifier: MIT
//
// The rings of a body as compressed rows of 32-bit indices, for layouts that do not bring their own:
// neighbours of a vertex, edges around a vertex, edges around a face. An edge entry is twice the edge plus
// one when flipped, as the Polyhedron's half-edges are, for both kinds of ring.
#pragma once

#include <algorithm>
#include <cassert>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/block.hpp"
#include "edgewise/table/body_facts.hpp"
#include "edgewise/table/loader.hpp"
#include "edgewise/table/needs.hpp"
#include "edgewise/table/ring.hpp"

namespace edgewise {

struct Rings {
    Index* vertex_offset = nullptr;
    Index* neighbour = nullptr;
    Index* vertex_ring = nullptr;
    Index* face_offset = nullptr;
    Index* face_ring = nullptr;

    /// The arrays of edges and faces are empty when only support is asked.
    void place(BlockPlan& plan, const BodyFacts& n) {
        const Shares topology = {{Component::topology, sizeof(Index)}};
        const bool features = n.parts == Parts::features;
        plan.array(vertex_offset, n.vertex_count + 1, topology);
        plan.array(neighbour, n.neighbour_count, topology);
        plan.array(vertex_ring, features ? n.neighbour_count : 0, topology);
        plan.array(face_offset, features ? n.face_count + 1 : 0, topology);
        plan.array(face_ring, n.face_ring_count(), topology);
    }

    void fill(const Polyhedron& body, Parts parts) const {
        assert(body.vertex_offset.size() == body.vertex_count() + 1);
        std::copy(body.vertex_offset.begin(), body.vertex_offset.end(), vertex_offset);
        std::transform(body.vertex_ring.begin(), body.vertex_ring.end(), neighbour,
                       [&](HalfEdge h) { return body.head(h); });
        if (parts == Parts::support) return;
        std::copy(body.vertex_ring.begin(), body.vertex_ring.end(), vertex_ring);
        std::copy(body.face_offset.begin(), body.face_offset.end(), face_offset);
        std::copy(body.face_ring.begin(), body.face_ring.end(), face_ring);
    }

    template <class Loader>
    [[nodiscard]] auto neighbours(const Loader& loader, Index v) const {
        return rows(loader, vertex_offset, v, Field::vertex_ring,
                    [this, &loader](Index at) { return loader.load(neighbour[at], Field::neighbour); });
    }
    template <class Loader>
    [[nodiscard]] auto ring_of_vertex(const Loader& loader, Index v) const {
        return rows(loader, vertex_offset, v, Field::vertex_ring, [this, &loader](Index at) {
            return decode(loader.load(vertex_ring[at], Field::vertex_ring));
        });
    }
    template <class Loader>
    [[nodiscard]] auto ring_of_face(const Loader& loader, Index f) const {
        return rows(loader, face_offset, f, Field::face_ring, [this, &loader](Index at) {
            return decode(loader.load(face_ring[at], Field::face_ring));
        });
    }

  private:
    static RingEdge<Index> decode(Index half_edge) { return {half_edge >> 1, (half_edge & 1) != 0}; }

    template <class Loader, class Reader>
    static auto rows(const Loader& loader, const Index* offset, Index row, Field field, Reader reader) {
        const Index first = loader.load(offset[row], field);
        const Index last = loader.load(offset[row + 1], field);
        return IndexedRing(first, last, reader);
    }
};

}  // namespace edgewise
