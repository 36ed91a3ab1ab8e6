// SPDX-License-Identifier: MIT
//
// What layouts have in common that differ in their edges alone: vertex coordinates and face planes as arrays
// of plain vectors and planes.
#pragma once

#include "edgewise/layout_parts/indexed_table.hpp"

namespace edgewise {

template <Precision P, class Loader>
class VertexFaceTable : public IndexedTable<P, Loader> {
    using Base = IndexedTable<P, Loader>;

  protected:
    using Base::block_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Face;
    using typename Base::Stored;
    using typename Base::Vertex;

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return cast<Compute>(load(vertices_[v], Field::vertex));
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        return cast<Compute>(load(faces_[f], Field::face_plane));
    }

    void write_vertex(Index v, const Vec3d& point) { vertices_[v] = cast<Stored>(point); }
    void write_face(Index f, const Plane<double>& plane) { faces_[f] = cast<Stored>(plane); }

  protected:
    template <Precision, class>
    friend class VertexFaceTable;

    explicit VertexFaceTable(Loader loader) : Base(loader) {}
    template <class OtherLoader>
    VertexFaceTable(const VertexFaceTable<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), vertices_(other.vertices_), faces_(other.faces_) {}

    /// Vertices, then what plan_edges(plan) plans, then faces and rings; allocated, rings filled.
    template <class PlanEdges>
    void build(const Polyhedron& body, Parts parts, PlanEdges plan_edges) {
        BlockPlan plan;
        const auto vertices = plan.array<Vec3<Stored>>(
            body.vertex_count(), {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        plan_edges(plan);
        const auto faces = plan.array<Plane<Stored>>(Base::faces_of(body, parts),
                                                     {{Component::face_planes, sizeof(Plane<Stored>)}});
        const RingSlots rings(plan, body, parts);

        this->allocate(std::move(plan), body, parts);
        vertices_ = block_.start(vertices);
        faces_ = block_.start(faces);
        this->rings_ = Rings(block_, rings, body);
    }

  private:
    Vec3<Stored>* vertices_ = nullptr;
    Plane<Stored>* faces_ = nullptr;
};

}  // namespace edgewise
