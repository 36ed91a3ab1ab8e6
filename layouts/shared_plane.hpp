// SPDX-License-Identifier: MIT
//
// The record of `aos` without its redundancy: of the four planes' sixteen scalars, the seven that do not
// follow from the rest. Both vertex-edge planes of an edge are normal to its direction d: the tail's is {-d,
// offset}, the head's {d, offset}. An edge-face plane contains the edge and is perpendicular to the face, of
// which the table keeps the normal n once: the plane's normal is n x d, and only its offset is kept. Nothing
// asks for the length: it is left out.
//
// In double every plane is that of `aos` to the bit, since n x d is computed in the same way, from the same
// numbers. In single and mixed, n and d are rounded before the product instead of after it. The price: an
// edge-face plane reads the face's line as well, and computes a square root for its length.
//
// Per edge 7 scalars instead of 20: d (3, counted as edge geometry, although it is the normal of two planes
// as well) and four offsets (counted as Voronoi planes). With four indices that is 72 bytes in double instead
// of 176, 44 in single instead of 96; neither needs padding.
#pragma once

#include <cassert>
#include <string_view>

#include "edgewise/layout_parts/stored_table.hpp"

namespace edgewise {

/// The record of one edge.
template <class Stored>
struct SharedPlaneRecord {
    Vec3<Stored> direction;  // the head plane's normal, and the tail plane's reversed
    Stored end_offset[2];    // by End
    Stored side_offset[2];   // by Side
    PolyhedronEdge ends;
};

template <class Stored>
struct SharedPlaneArrays {
    Vec3<Stored>* vertices = nullptr;
    SharedPlaneRecord<Stored>* edges = nullptr;
    Plane<Stored>* faces = nullptr;

    void place(BlockPlan& plan, const BodyFacts& n) {
        plan.array(vertices, n.vertex_count, {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        plan.array(edges, n.edge_count(),
                   {{Component::edge_geometry, sizeof(Vec3<Stored>)},
                    {Component::voronoi_planes, 4 * sizeof(Stored)},
                    {Component::topology, 4 * sizeof(Index)}});
        plan.array(faces, n.face_count, {{Component::face_planes, sizeof(Plane<Stored>)}});
    }

    [[nodiscard]] auto& vertex(Index v) const { return vertices[v]; }
    [[nodiscard]] auto& direction(Index e) const { return edges[e].direction; }
    [[nodiscard]] auto& end_offset(Index e, End end) const {
        return edges[e].end_offset[static_cast<int>(end)];
    }
    [[nodiscard]] auto& side_offset(Index e, Side side) const {
        return edges[e].side_offset[static_cast<int>(side)];
    }
    [[nodiscard]] auto& ends(Index e) const { return edges[e].ends; }
    [[nodiscard]] auto& face_plane(Index f) const { return faces[f]; }

    void write_edge(Index e, const EdgeGeometry& g) const {
        direction(e) = cast<Stored>(g.direction);
        end_offset(e, End::tail) = static_cast<Stored>(g.tail_plane.offset);
        end_offset(e, End::head) = static_cast<Stored>(g.head_plane.offset);
        side_offset(e, Side::left) = static_cast<Stored>(g.left_plane.offset);
        side_offset(e, Side::right) = static_cast<Stored>(g.right_plane.offset);
    }
};

template <Precision P, class Loader = Direct>
class shared_plane : public StoredTable<SharedPlaneArrays<typename P::Stored>, P, Loader> {
    using Base = StoredTable<SharedPlaneArrays<typename P::Stored>, P, Loader>;
    using Base::load;

  protected:
    using Base::at_;

  public:
    using typename Base::Compute, typename Base::Edge, typename Base::Face;

    static constexpr std::string_view name = "shared_plane";
    static constexpr std::string_view stores =
        "one struct per edge: direction, the offsets of its four planes, ends";
    static constexpr std::string_view derives =
        "normals of Voronoi planes, from direction and face normal; no length";

    using Base::Base;

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        const Vec3<Compute> along = normal_at_head(e);
        const Compute offset = load(at_.end_offset(e, end), Field::voronoi_plane);
        return {end == End::head ? along : Vec3<Compute>(-along), offset};
    }

    /// Computes the edge-face plane as layout_parts/voronoi.hpp does, from the stored numbers.
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        const Face face = side == Side::left ? this->left(e) : this->right(e);
        const Compute offset = load(at_.side_offset(e, side), Field::voronoi_plane);
        if (face == no_face) return {Vec3<Compute>::Zero(), offset};
        const Vec3<Compute> along = normal_at_head(e);
        const Vec3<Compute> into =
            cross(this->face_plane(face).normal, side == Side::left ? along : Vec3<Compute>(-along));
        return {into / norm(into), offset};
    }

  private:
    [[nodiscard]] Vec3<Compute> normal_at_head(Edge e) const {
        assert(e < this->facts_.edge_count());
        return cast<Compute>(load(at_.direction(e), Field::voronoi_plane));
    }
};

}  // namespace edgewise
