// SPDX-License-Identifier: MIT
//
// Array of structures: the paper's record. One struct per edge with its four Voronoi planes, direction and
// length: 16 + 3 + 1 = 20 scalars; with the edge's share of the vertex coordinates (3 scalars for V/E -> 1/3)
// 21 scalars, 168 bytes in double and 84 in single. Topology, face planes and padding come on top and are
// counted separately.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/stored_table.hpp"

namespace edgewise {

template <class Stored>
struct AosRecord {
    Plane<Stored> vertex_edge[2];  // by End
    Plane<Stored> edge_face[2];    // by Side
    Vec3<Stored> direction;
    Stored length;
    PolyhedronEdge ends;

    /// Purposes of the record's bytes, in memory order.
    static Shares shares() {
        return {{Component::voronoi_planes, 4 * sizeof(Plane<Stored>)},
                {Component::edge_geometry, 4 * sizeof(Stored)},
                {Component::topology, 4 * sizeof(Index)}};
    }
};

template <class Stored, class Record = AosRecord<Stored>>
struct AosArrays {
    Vec3<Stored>* vertices = nullptr;
    Record* edges = nullptr;
    Plane<Stored>* faces = nullptr;

    void place(BlockPlan& plan, const BodyFacts& n) {
        plan.array(vertices, n.vertex_count, {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        plan.array(edges, n.edge_count(), Record::shares());
        plan.array(faces, n.face_count, {{Component::face_planes, sizeof(Plane<Stored>)}});
    }

    [[nodiscard]] auto& vertex(Index v) const { return vertices[v]; }
    [[nodiscard]] auto& vertex_edge_plane(Index e, End end) const {
        return edges[e].vertex_edge[static_cast<int>(end)];
    }
    [[nodiscard]] auto& edge_face_plane(Index e, Side side) const {
        return edges[e].edge_face[static_cast<int>(side)];
    }
    [[nodiscard]] auto& direction(Index e) const { return edges[e].direction; }
    [[nodiscard]] auto& length(Index e) const { return edges[e].length; }
    [[nodiscard]] auto& ends(Index e) const { return edges[e].ends; }
    [[nodiscard]] auto& face_plane(Index f) const { return faces[f]; }
};

template <Precision P, class Loader = Direct>
class aos : public StoredTable<AosArrays<typename P::Stored>, P, Loader> {
    using Base = StoredTable<AosArrays<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "aos";
    static constexpr std::string_view stores =
        "one struct per edge: four Voronoi planes, direction, length, ends";
    static constexpr bool measured_at_scales = true;

    using Base::Base;
};

}  // namespace edgewise
