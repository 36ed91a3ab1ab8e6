// SPDX-License-Identifier: MIT
//
// The nodes of the layout `linked`, and what their bytes are for.
#pragma once

#include <cstddef>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/voronoi.hpp"
#include "edgewise/table/pieces.hpp"

namespace edgewise {

template <class Stored>
struct LinkedNodes {
    struct Spoke;
    struct VertexCone;
    struct FaceCone;

    static constexpr std::size_t pointer = sizeof(void*);
    static constexpr Share plane_share{Component::voronoi_planes, sizeof(Plane<Stored>)};

    struct Vertex {
        Vec3<Stored> point;
        Index index;  // in the canonical body
        Spoke* spokes;
        Vertex* next;
        static Shares shares() {
            return {{Component::vertex_coordinates, sizeof(Vec3<Stored>)},
                    {Component::topology, sizeof(Index)},
                    {Component::padding, (sizeof(Vec3<Stored>) + sizeof(Index)) % pointer},
                    {Component::topology, 2 * pointer}};
        }
    };
    struct Face {
        Plane<Stored> plane;
        FaceCone* cone;
        Face* next;
        static Shares shares() {
            return {{Component::face_planes, sizeof(Plane<Stored>)}, {Component::topology, 2 * pointer}};
        }
    };
    struct Edge {
        Vec3<Stored> direction;
        Stored length;
        Vertex* end[2];              // by End
        Face* side[2];               // by Side
        VertexCone* vertex_cone[2];  // by End
        FaceCone* face_cone[2];      // by Side
        static Shares shares() {
            return {{Component::edge_geometry, 4 * sizeof(Stored)}, {Component::topology, 8 * pointer}};
        }
        /// Its planes are kept in the cones.
        void write(const EdgeGeometry& g) {
            direction = cast<Stored>(g.direction);
            length = static_cast<Stored>(g.length);
            vertex_cone[0]->plane = cast<Stored>(g.tail_plane);
            vertex_cone[1]->plane = cast<Stored>(g.head_plane);
            if (face_cone[0]) face_cone[0]->plane = cast<Stored>(g.left_plane);
            if (face_cone[1]) face_cone[1]->plane = cast<Stored>(g.right_plane);
        }
    };
    /// One way out of a vertex: all that a support table knows of an edge.
    struct Spoke {
        Vertex* neighbour;
        Spoke* next;
        static Shares shares() { return {{Component::topology, 2 * pointer}}; }
    };
    struct VertexCone : Spoke {
        Plane<Stored> plane;
        Edge* edge;
        static Shares shares() {
            return {{Component::topology, 2 * pointer}, plane_share, {Component::topology, pointer}};
        }
    };
    struct FaceCone {
        Plane<Stored> plane;
        Edge* edge;
        FaceCone* next;
        static Shares shares() { return {plane_share, {Component::topology, 2 * pointer}}; }
    };
};

}  // namespace edgewise
