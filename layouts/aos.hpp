// SPDX-License-Identifier: MIT
//
// Array of structures: the paper's record. One struct an edge with its four Voronoi planes, direction and
// length: 16 + 3 + 1 = 20 scalars; with the edge's share of the vertex coordinates (3 scalars for V/E -> 1/3)
// 21 scalars, 168 bytes in double and 84 in single. Topology, face planes and padding come on top and are
// counted apart.
#pragma once

#include "edgewise/layout_parts/record_table.hpp"

namespace edgewise {

/// The record of one edge.
template <class Stored>
struct AosRecord {
    Plane<Stored> vertex_edge[2];  // by End
    Plane<Stored> edge_face[2];    // by Side
    Vec3<Stored> direction;
    Stored length;
    PolyhedronEdge ends;

    static Shares shares() {
        return {{Component::voronoi_planes, 4 * sizeof(Plane<Stored>)},
                {Component::edge_geometry, 4 * sizeof(Stored)},
                {Component::topology, 4 * sizeof(Index)}};
    }
};

template <Precision P, class Loader = Direct>
class aos : public RecordTable<P, Loader, AosRecord<typename P::Stored>> {
    using Base = RecordTable<P, Loader, AosRecord<typename P::Stored>>;

  public:
    static constexpr std::string_view name = "aos";
    static constexpr std::string_view stores =
        "one struct an edge: four Voronoi planes, direction, length, ends";
    static constexpr std::string_view derives = "nothing";

    aos(const Polyhedron& body, Parts parts, Loader loader = {}, WriteEdges write = WriteEdges::now)
        : Base(body, parts, loader, write) {}

    /// The same memory seen through another loader.
    template <class OtherLoader>
    aos(const aos<P, OtherLoader>& other, Loader loader) : Base(other, loader) {}
};

}  // namespace edgewise
