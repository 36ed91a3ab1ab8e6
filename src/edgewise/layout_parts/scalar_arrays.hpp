// SPDX-License-Identifier: MIT
//
// Structure of arrays: each scalar of a body in an array of its own: twenty for an edge, three for a vertex,
// four for a face, four indices for an edge's ends. For layouts that differ in where the arrays start.
#pragma once

#include <array>
#include <cstddef>

#include "edgewise/layout_parts/indexed_table.hpp"

namespace edgewise {

/// How far arrays are apart from start to start: back to back in whole lines, or an odd number of lines.
enum class Spacing : bool { back_to_back, odd_lines };

template <Precision P, class Loader, Spacing spacing>
class ScalarArrays : public IndexedTable<P, Loader> {
    using Base = IndexedTable<P, Loader>;

  protected:
    using Base::block_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Face;
    using typename Base::Stored;
    using typename Base::Vertex;

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const { return vector(&vertices_[0], v, Field::vertex); }

    [[nodiscard]] Vertex tail(Edge e) const { return load(ends_[0][e], Field::edge_ends); }
    [[nodiscard]] Vertex head(Edge e) const { return load(ends_[1][e], Field::edge_ends); }
    [[nodiscard]] Face left(Edge e) const { return load(ends_[2][e], Field::edge_ends); }
    [[nodiscard]] Face right(Edge e) const { return load(ends_[3][e], Field::edge_ends); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        return vector(&geometry_[0], e, Field::edge_direction);
    }

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        return plane(&voronoi_[4 * static_cast<std::size_t>(end)], e, Field::voronoi_plane);
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        return plane(&voronoi_[8 + 4 * static_cast<std::size_t>(side)], e, Field::voronoi_plane);
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const { return plane(&faces_[0], f, Field::face_plane); }

    void write_vertex(Index v, const Vec3d& point) {
        for (int k = 0; k < 3; ++k) vertices_[k][v] = static_cast<Stored>(point[k]);
    }
    void write_face(Index f, const Plane<double>& face) { write_plane(&faces_[0], f, face); }
    void write_edge(Index e, const EdgeGeometry& g) {
        write_plane(&voronoi_[0], e, g.tail_plane);
        write_plane(&voronoi_[4], e, g.head_plane);
        write_plane(&voronoi_[8], e, g.left_plane);
        write_plane(&voronoi_[12], e, g.right_plane);
        write_plane(&geometry_[0], e, {g.direction, g.length});
    }

  protected:
    template <Precision, class, Spacing>
    friend class ScalarArrays;

    ScalarArrays(const Polyhedron& body, Parts parts, Loader loader, WriteEdges write) : Base(loader) {
        const std::size_t edges = Base::edges_of(body, parts);
        BlockPlan plan;
        const auto vertices = plan_arrays<3>(plan, body.vertex_count(), Component::vertex_coordinates);
        const auto voronoi = plan_arrays<16>(plan, edges, Component::voronoi_planes);
        const auto geometry = plan_arrays<4>(plan, edges, Component::edge_geometry);
        const auto faces = plan_arrays<4>(plan, Base::faces_of(body, parts), Component::face_planes);
        const auto ends = plan_arrays<4, Index>(plan, edges, Component::topology);
        const RingSlots rings(plan, body, parts);

        this->allocate(std::move(plan), body, parts);
        vertices_ = place(vertices);
        voronoi_ = place(voronoi);
        geometry_ = place(geometry);
        faces_ = place(faces);
        ends_ = place(ends);
        this->rings_ = Rings(block_, rings, body);
        for (std::size_t e = 0; e < edges; ++e) {
            const PolyhedronEdge& edge = body.edges[e];
            const std::array all = {edge.tail, edge.head, edge.left, edge.right};
            for (std::size_t k = 0; k < all.size(); ++k) ends_[k][e] = all[k];
        }
        write_geometry(*this, body, write);
    }
    template <class OtherLoader>
    ScalarArrays(const ScalarArrays<P, OtherLoader, spacing>& other, Loader loader)
        : Base(other, loader),
          vertices_(other.vertices_),
          voronoi_(other.voronoi_),
          geometry_(other.geometry_),
          faces_(other.faces_),
          ends_(other.ends_) {}

  private:
    static constexpr std::size_t line = BlockPlan::alignment;

    template <std::size_t Count, class Element = Stored>
    static std::array<Slot<Element>, Count> plan_arrays(BlockPlan& plan, std::size_t length, Component use) {
        const std::size_t lines = (length * sizeof(Element) + line - 1) / line;
        const bool gap = spacing == Spacing::odd_lines && length > 0 && lines % 2 == 0;
        std::array<Slot<Element>, Count> slots;
        for (auto& slot : slots) {
            slot = plan.array<Element>(length, {{use, sizeof(Element)}});
            if (gap) plan.array<std::byte>(line, {});
        }
        return slots;
    }
    template <class Element, std::size_t Count>
    std::array<Element*, Count> place(const std::array<Slot<Element>, Count>& slots) const {
        std::array<Element*, Count> arrays;
        for (std::size_t k = 0; k < Count; ++k) arrays[k] = block_.start(slots[k]);
        return arrays;
    }

    static void write_plane(Stored* const* arrays, Index i, const Plane<double>& p) {
        for (int k = 0; k < 3; ++k) arrays[k][i] = static_cast<Stored>(p.normal[k]);
        arrays[3][i] = static_cast<Stored>(p.offset);
    }
    Vec3<Compute> vector(const Stored* const* arrays, Index i, Field field) const {
        const auto read = [&](int k) { return static_cast<Compute>(load(arrays[k][i], field)); };
        return {read(0), read(1), read(2)};
    }
    Plane<Compute> plane(const Stored* const* arrays, Index i, Field field) const {
        return {vector(arrays, i, field), static_cast<Compute>(load(arrays[3][i], field))};
    }

    std::array<Stored*, 3> vertices_{};
    std::array<Stored*, 16> voronoi_{};  // tail, head, left, right plane: normal and offset each
    std::array<Stored*, 4> geometry_{};  // direction, length
    std::array<Stored*, 4> faces_{};     // normal and offset
    std::array<Index*, 4> ends_{};       // tail, head, left, right
};

}  // namespace edgewise
