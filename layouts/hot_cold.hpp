// SPDX-License-Identifier: MIT
//
// The record of `aos`, split in two. Hot: the four Voronoi planes, which V-Clip's tests read edge after edge
// along a ring. Cold: ends, direction and length. The split makes the hot record a round number of cache
// lines (128 bytes in double, two lines; 64 in single, one), so that no plane straddles two lines and a ring
// reads only planes.
//
// Why direction is cold: rings of planes never need it. A vertex over a face (V-F) asks for the slopes of all
// edges at the vertex, and reads directions without planes; an edge over a face (E-F) asks for the slope of
// an edge after it has read its ends. Only E-E reads it of an edge with planes under test, and only where the
// other edge is clipped by a face. Next to the planes it would spoil their alignment. That is also the only
// reason why ends are cold: V-E, E-E and E-F read them of one edge per body in every test. Nothing reads the
// length; it is kept so that the two records hold the scalars of `aos`.
//
// Per edge 128 + 48 bytes in double, 64 + 32 in single: the same total as in `aos`, to the byte.
#pragma once

#include <string_view>

#include "edgewise/layout_parts/stored_table.hpp"

namespace edgewise {

/// The part of an edge that tests against a Voronoi region read.
template <class Stored>
struct HotEdge {
    Plane<Stored> vertex_edge[2];  // by End
    Plane<Stored> edge_face[2];    // by Side
};

/// The part of an edge that says where it runs and what it joins.
template <class Stored>
struct ColdEdge {
    PolyhedronEdge ends;
    Vec3<Stored> direction;
    Stored length;
};

template <class Stored>
struct HotColdArrays {
    Vec3<Stored>* vertices = nullptr;
    HotEdge<Stored>* hot = nullptr;
    ColdEdge<Stored>* cold = nullptr;
    Plane<Stored>* faces = nullptr;

    void place(BlockPlan& plan, const BodyFacts& n) {
        plan.array(vertices, n.vertex_count, {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        plan.array(hot, n.edge_count(), {{Component::voronoi_planes, 4 * sizeof(Plane<Stored>)}});
        plan.array(
            cold, n.edge_count(),
            {{Component::topology, 4 * sizeof(Index)}, {Component::edge_geometry, 4 * sizeof(Stored)}});
        plan.array(faces, n.face_count, {{Component::face_planes, sizeof(Plane<Stored>)}});
    }

    [[nodiscard]] auto& vertex(Index v) const { return vertices[v]; }
    [[nodiscard]] auto& vertex_edge_plane(Index e, End end) const {
        return hot[e].vertex_edge[static_cast<int>(end)];
    }
    [[nodiscard]] auto& edge_face_plane(Index e, Side side) const {
        return hot[e].edge_face[static_cast<int>(side)];
    }
    [[nodiscard]] auto& direction(Index e) const { return cold[e].direction; }
    [[nodiscard]] auto& length(Index e) const { return cold[e].length; }
    [[nodiscard]] auto& ends(Index e) const { return cold[e].ends; }
    [[nodiscard]] auto& face_plane(Index f) const { return faces[f]; }
};

template <Precision P, class Loader = Direct>
class hot_cold : public StoredTable<HotColdArrays<typename P::Stored>, P, Loader> {
    using Base = StoredTable<HotColdArrays<typename P::Stored>, P, Loader>;

  public:
    static constexpr std::string_view name = "hot_cold";
    static constexpr std::string_view stores =
        "two structs per edge: four Voronoi planes; and separately ends, direction, length";

    using Base::Base;
};

}  // namespace edgewise
