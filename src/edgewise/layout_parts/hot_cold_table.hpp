// SPDX-License-Identifier: MIT
//
// Two structs an edge, each in an array of its own: the four Voronoi planes, and apart from them ends,
// direction and length. For layouts that differ in when the planes are written. Why the split runs there:
// layouts/hot_cold.hpp.
#pragma once

#include "edgewise/layout_parts/edge_records.hpp"

namespace edgewise {

/// What tests against a Voronoi region read of an edge.
template <class Stored>
struct HotEdge {
    Plane<Stored> vertex_edge[2];  // by End
    Plane<Stored> edge_face[2];    // by Side
};

/// What says where the edge runs and what it joins.
template <class Stored>
struct ColdEdge {
    PolyhedronEdge ends;
    Vec3<Stored> direction;
    Stored length;
};

template <Precision P, class Loader>
class HotColdTable : public EdgeRecords<P, Loader, ColdEdge<typename P::Stored>> {
    using Base = EdgeRecords<P, Loader, ColdEdge<typename P::Stored>>;
    using Base::block_;
    using Base::edges_;
    using Base::load;

  public:
    using typename Base::Compute;
    using typename Base::Edge;
    using typename Base::Stored;

    [[nodiscard]] Plane<Compute> vertex_edge_plane(Edge e, End end) const {
        return cast<Compute>(load(hot_[e].vertex_edge[static_cast<int>(end)], Field::voronoi_plane));
    }
    [[nodiscard]] Plane<Compute> edge_face_plane(Edge e, Side side) const {
        return cast<Compute>(load(hot_[e].edge_face[static_cast<int>(side)], Field::voronoi_plane));
    }

    void write_edge(Index e, const EdgeGeometry& g) {
        hot_[e] = {{cast<Stored>(g.tail_plane), cast<Stored>(g.head_plane)},
                   {cast<Stored>(g.left_plane), cast<Stored>(g.right_plane)}};
        edges_[e].direction = cast<Stored>(g.direction);
        edges_[e].length = static_cast<Stored>(g.length);
    }

  protected:
    template <Precision, class>
    friend class HotColdTable;

    HotColdTable(const Polyhedron& body, Parts parts, Loader loader, WriteEdges write) : Base(loader) {
        const std::size_t count = Base::edges_of(body, parts);
        Slot<Hot> hot{};
        Slot<Cold> cold{};
        this->build(body, parts, [&](BlockPlan& plan) {
            hot = plan.array<Hot>(count, {{Component::voronoi_planes, 4 * sizeof(Plane<Stored>)}});
            cold = plan.array<Cold>(count, {{Component::topology, 4 * sizeof(Index)},
                                            {Component::edge_geometry, 4 * sizeof(Stored)}});
        });
        hot_ = block_.start(hot);
        this->start_edges(cold, body);
        write_geometry(*this, body, write);
    }

    /// The same memory seen through another loader.
    template <class OtherLoader>
    HotColdTable(const HotColdTable<P, OtherLoader>& other, Loader loader)
        : Base(other, loader), hot_(other.hot_) {}

  private:
    using Hot = HotEdge<Stored>;
    using Cold = ColdEdge<Stored>;

    Hot* hot_ = nullptr;
};

}  // namespace edgewise
