// SPDX-License-Identifier: MIT
//
// Array of structures of arrays: blocks of as many edges as a cache line has scalars, 8 in double and 16 in
// single. In a block, scalar k of all its edges is one row, and a row of scalars is one 64-byte line (of
// indices, half a line in double): scalar k of edge e
// is block[e / lanes].row[k][e % lanes]. A pass over all edges reads whole lines as with `soa`, yet the
// twenty scalars of one edge lie in one place of 20 lines, not in twenty places. Vertices, faces and the
// edges' ends go by blocks as well. The bytes are those of `soa`; only the lanes that the last block does not
// fill are padding.
#pragma once

#include <array>
#include <initializer_list>

#include "edgewise/layout_parts/indexed_table.hpp"

namespace edgewise {

/// `Rows` scalars each of as many things as a cache line holds of `Stored`.
template <class Stored, class Scalar, std::size_t Rows>
struct LaneBlock {
    static constexpr std::size_t lanes = BlockPlan::alignment / sizeof(Stored);

    Scalar row[Rows][lanes];
};

/// The edges of one block: planes in the order tail, head, left, right; ends likewise.
template <class Stored>
struct EdgeBlock {
    LaneBlock<Stored, Stored, 16> planes;
    LaneBlock<Stored, Stored, 4> geometry;
    LaneBlock<Stored, Index, 4> ends;
};

template <Precision P, class Loader = Direct>
class aosoa : public IndexedTable<P, Loader> {
    using Base = IndexedTable<P, Loader>;
    using Base::block_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Face;
    using typename Base::Stored;
    using typename Base::Vertex;

    static constexpr std::string_view name = "aosoa";
    static constexpr std::string_view stores = "blocks of edges, a cache line a scalar: 8 in f64, 16 in f32";
    static constexpr std::string_view derives = "nothing";

    aosoa(const Polyhedron& body, Parts parts, Loader loader = {}, WriteEdges write = WriteEdges::now)
        : Base(loader) {
        const std::size_t count = Base::edges_of(body, parts);
        BlockPlan plan;
        const auto vertices = plan_blocks<Points>(plan, body.vertex_count(),
                                                  {{Component::vertex_coordinates, 3, sizeof(Stored)}});
        const auto edges = plan_blocks<Edges>(plan, count,
                                              {{Component::voronoi_planes, 16, sizeof(Stored)},
                                               {Component::edge_geometry, 4, sizeof(Stored)},
                                               {Component::topology, 4, sizeof(Index)}});
        const auto faces = plan_blocks<Planes>(plan, Base::faces_of(body, parts),
                                               {{Component::face_planes, 4, sizeof(Stored)}});
        const RingSlots rings(plan, body, parts);

        this->allocate(std::move(plan), body, parts);
        vertices_ = block_.start(vertices);
        edges_ = block_.start(edges);
        faces_ = block_.start(faces);
        this->rings_ = Rings(block_, rings, body);
        for (Index e = 0; e < count; ++e) {
            const PolyhedronEdge& edge = body.edges[e];
            const std::array ends = {edge.tail, edge.head, edge.left, edge.right};
            for (std::size_t k = 0; k < ends.size(); ++k) edges_[e / lanes].ends.row[k][e % lanes] = ends[k];
        }
        write_geometry(*this, body, write);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    aosoa(const aosoa<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), vertices_(other.vertices_), edges_(other.edges_), faces_(other.faces_) {}

    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        return vector(&vertices_[v / lanes].row[0], v, Field::vertex);
    }

    [[nodiscard]] Vertex tail(Edge e) const { return end(0, e); }
    [[nodiscard]] Vertex head(Edge e) const { return end(1, e); }
    [[nodiscard]] Face left(Edge e) const { return end(2, e); }
    [[nodiscard]] Face right(Edge e) const { return end(3, e); }
    [[nodiscard]] Vec3<Compute> direction(Edge e) const {
        return vector(&edges_[e / lanes].geometry.row[0], e, Field::edge_direction);
    }

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        return plane(&edges_[e / lanes].planes.row[4 * static_cast<int>(end)], e, Field::voronoi_plane);
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        return plane(&edges_[e / lanes].planes.row[8 + 4 * static_cast<int>(side)], e, Field::voronoi_plane);
    }
    [[nodiscard]] Plane<Compute> face_plane(Face f) const {
        return plane(&faces_[f / lanes].row[0], f, Field::face_plane);
    }

    void write_vertex(Index v, const Vec3d& point) {
        for (int k = 0; k < 3; ++k) vertices_[v / lanes].row[k][v % lanes] = static_cast<Stored>(point[k]);
    }
    void write_face(Index f, const Plane<double>& face) {
        write_plane(&faces_[f / lanes].row[0], f % lanes, face);
    }
    void write_edge(Index e, const EdgeGeometry& g) {
        Edges& to = edges_[e / lanes];
        const std::size_t lane = e % lanes;
        write_plane(&to.planes.row[0], lane, g.tail_plane);
        write_plane(&to.planes.row[4], lane, g.head_plane);
        write_plane(&to.planes.row[8], lane, g.left_plane);
        write_plane(&to.planes.row[12], lane, g.right_plane);
        write_plane(&to.geometry.row[0], lane, {g.direction, g.length});
    }

  private:
    template <Precision, class>
    friend class aosoa;

    using Points = LaneBlock<Stored, Stored, 3>;
    using Planes = LaneBlock<Stored, Stored, 4>;
    using Edges = EdgeBlock<Stored>;
    static constexpr std::size_t lanes = Points::lanes;
    using Row = Stored[lanes];
    static_assert(sizeof(Row) == BlockPlan::alignment && sizeof(Edges) % BlockPlan::alignment == 0);

    /// Rows of one kind in a block.
    struct Rows {
        Component component;
        std::size_t count, scalar;
    };

    /// The last block, if not full, is planned row by row: its free lanes are padding. Blocks are whole
    /// lines, so it follows the others without a gap.
    template <class Element>
    static Slot<Element> plan_blocks(BlockPlan& plan, std::size_t count, std::initializer_list<Rows> kinds) {
        Shares shares;
        for (const Rows& rows : kinds) shares.add({rows.component, rows.count * rows.scalar * lanes});
        const auto full = plan.array<Element>(count / lanes, shares);
        const std::size_t rest = count % lanes;
        if (rest == 0) return full;
        for (const Rows& rows : kinds) {
            for (std::size_t k = 0; k < rows.count; ++k)
                plan.append(rows.scalar * lanes, {{rows.component, rows.scalar * rest}});
        }
        return {full.offset, full.count + 1};
    }

    static void write_plane(Row* rows, std::size_t lane, const Plane<double>& p) {
        for (int k = 0; k < 3; ++k) rows[k][lane] = static_cast<Stored>(p.normal[k]);
        rows[3][lane] = static_cast<Stored>(p.offset);
    }

    Index end(int k, Edge e) const {
        return load(edges_[e / lanes].ends.row[k][e % lanes], Field::edge_ends);
    }
    Vec3<Compute> vector(const Row* rows, Index i, Field field) const {
        const auto read = [&](int k) { return static_cast<Compute>(load(rows[k][i % lanes], field)); };
        return {read(0), read(1), read(2)};
    }
    Plane<Compute> plane(const Row* rows, Index i, Field field) const {
        return {vector(rows, i, field), static_cast<Compute>(load(rows[3][i % lanes], field))};
    }

    Points* vertices_ = nullptr;
    Edges* edges_ = nullptr;
    Planes* faces_ = nullptr;
};

}  // namespace edgewise
