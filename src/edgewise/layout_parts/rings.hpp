// SPDX-License-Identifier: MIT
//
// The rings of a body as compressed rows of 32-bit indices, for layouts that do not bring their own:
// neighbours of a vertex, edges around a vertex, edges around a face. An edge entry is twice the edge plus
// one when flipped.
#pragma once

#include <cstdint>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/block.hpp"
#include "edgewise/table/loader.hpp"
#include "edgewise/table/needs.hpp"
#include "edgewise/table/ring.hpp"

namespace edgewise {

/// Where the ring arrays lie in the block; the face arrays are empty when only support is asked.
struct RingSlots {
    Slot<Index> vertex_offset, neighbour, vertex_ring, face_offset, face_ring;

    RingSlots(BlockPlan& plan, const Polyhedron& body, Parts parts) {
        const auto topology = [&](std::size_t count) {
            return plan.array<Index>(count, {{Component::topology, sizeof(Index)}});
        };
        const bool features = parts == Parts::features;
        vertex_offset = topology(body.vertex_count() + 1);
        neighbour = topology(body.vertex_ring.size());
        vertex_ring = topology(features ? body.vertex_ring.size() : 0);
        face_offset = topology(features ? body.face_count() + 1 : 0);
        face_ring = topology(features ? body.face_ring.size() : 0);
    }
};

/// Views of the ring arrays. The Polyhedron's half-edges already are 2 * edge + flipped, for both kinds of
/// ring.
struct Rings {
    const Index* vertex_offset = nullptr;
    const Index* neighbour = nullptr;
    const Index* vertex_ring = nullptr;
    const Index* face_offset = nullptr;
    const Index* face_ring = nullptr;

    Rings() = default;
    Rings(const Block& block, const RingSlots& slots, const Polyhedron& body)
        : vertex_offset(fill(block, slots.vertex_offset, body.vertex_offset)),
          neighbour(fill(block, slots.neighbour, neighbours_of(body))),
          vertex_ring(fill(block, slots.vertex_ring, body.vertex_ring)),
          face_offset(fill(block, slots.face_offset, body.face_offset)),
          face_ring(fill(block, slots.face_ring, body.face_ring)) {}

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

    static std::vector<Index> neighbours_of(const Polyhedron& body) {
        std::vector<Index> result;
        result.reserve(body.vertex_ring.size());
        for (const HalfEdge h : body.vertex_ring) result.push_back(body.head(h));
        return result;
    }

    static const Index* fill(const Block& block, Slot<Index> slot, const std::vector<Index>& from) {
        return block.fill(slot, [&](Index i) { return from[i]; });
    }
};

}  // namespace edgewise
