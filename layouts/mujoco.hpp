// SPDX-License-Identifier: MIT
//
// The convex hull graph of MuJoCo (revision a7255075, mjModel's mesh_graph): two counts; for each vertex of
// the hull the start of its neighbours and its number in the mesh; neighbours, each list ended by -1; three
// vertices for each triangle; and 27 vertices to begin at, in the directions of a 3 x 3 x 3 grid. All of 32
// bits, coordinates in single and computed with in double: 24.1 bytes per edge at 218 vertices and 24 in the
// limit, and 108 bytes. Only the structure is the engine's, from its published list of fields; the algorithms
// are ours. For GJK only: the graph has no order around a vertex in the engine.
//
// Departures: only the hull's edges are in the graph, where the engine cuts faces into triangles first; a
// list's neighbours are in cyclic order, as in every table here; the mesh is the hull. Faces are always
// stored, and not read.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "edgewise/layout_parts/block_table.hpp"
#include "edgewise/layout_parts/seeds.hpp"

namespace edgewise {

/// The start of each array, in bytes from the block's start.
template <class Stored>
struct MujocoPlaces {
    std::uint32_t points = 0, counts = 0, begins = 0, in_mesh = 0, neighbours = 0, triangles = 0, seeds = 0;

    /// Number of triangles when all faces are cut into triangles.
    [[nodiscard]] static Index triangle_count(const BodyFacts& n) {
        return n.face_ring_count() - 2 * n.face_count;
    }

    void place(BlockPlan& plan, const BodyFacts& n) {
        const Shares number = {{Component::topology, sizeof(std::int32_t)}};
        points = plan.array_at<Vec3<Stored>>(n.vertex_count,
                                             {{Component::vertex_coordinates, sizeof(Vec3<Stored>)}});
        counts = plan.array_at<std::int32_t>(2, number);
        begins = plan.array_at<std::int32_t>(n.vertex_count, number);
        in_mesh = plan.array_at<std::int32_t>(n.vertex_count, number);
        neighbours = plan.array_at<std::int32_t>(n.vertex_count + n.neighbour_count, number);
        triangles = plan.array_at<std::int32_t>(3 * std::size_t{triangle_count(n)}, number);
        seeds = plan.array_at<std::int32_t>(CornerDirections::count, number);
    }
};

/// Range of the numbers of a list up to the -1 that ends it, each read once.
template <class Loader>
class MujocoList {
  public:
    MujocoList(const Loader& loader, const std::int32_t* at) : loader_(loader), at_(at) { read(); }

    [[nodiscard]] MujocoList begin() const { return *this; }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }
    [[nodiscard]] Index operator*() const { return static_cast<Index>(number_); }
    MujocoList& operator++() {
        ++at_;
        read();
        return *this;
    }
    bool operator!=(std::default_sentinel_t) const { return number_ != -1; }

  private:
    void read() { number_ = loader_.load(*at_, Field::neighbour); }

    [[no_unique_address]] Loader loader_;
    const std::int32_t* at_;
    std::int32_t number_ = -1;
};

template <Precision P, class Loader = Direct>
class mujoco : public PlacedTable<MujocoPlaces<typename P::Stored>, P, Loader> {
    using Base = PlacedTable<MujocoPlaces<typename P::Stored>, P, Loader>;
    using Base::facts_, Base::load, Base::places_;

  public:
    using typename Base::Compute, typename Base::Stored, typename Base::Vertex;

    static constexpr std::string_view name = "mujoco";
    static constexpr std::string_view stores =
        "MuJoCo's hull (a7255075): coordinates, a graph of 32-bit numbers with its triangles, 27 seeds";
    static constexpr std::string_view derives = "nothing";

    /// Both kinds of parts are the same here: the engine keeps everything.
    mujoco(const Polyhedron& body, Parts /*parts*/, Loader loader = {})
        : Base(body, Parts::features, loader) {
        numbers(places_.counts)[0] = static_cast<std::int32_t>(facts_.vertex_count);
        numbers(places_.counts)[1] = static_cast<std::int32_t>(Places::triangle_count(facts_));
        link_neighbours(body);
        link_triangles(body);
        write_body(body);
    }

    using Base::Base;

    void write_body(const Polyhedron& body) {
        for (Index v = 0; v < facts_.vertex_count; ++v) points()[v] = cast<Stored>(body.vertices[v]);
        for (Index i = 0; i < CornerDirections::count; ++i)
            numbers(places_.seeds)[i] =
                static_cast<std::int32_t>(farthest_vertex(body, CornerDirections::direction(i)));
    }

    /// Coordinates of the vertex, by its number in the mesh.
    [[nodiscard]] Vec3<Compute> vertex(Vertex v) const {
        assert(v < facts_.vertex_count);
        const std::int32_t in_mesh = load(numbers(places_.in_mesh)[v], Field::vertex);
        return cast<Compute>(load(points()[in_mesh], Field::vertex));
    }
    [[nodiscard]] auto neighbours(Vertex v) const {
        const std::int32_t begin = load(numbers(places_.begins)[v], Field::vertex_ring);
        return MujocoList<Loader>(this->loader_, numbers(places_.neighbours) + begin);
    }
    /// Returns a vertex that is far along the direction, which may have any length.
    [[nodiscard]] Vertex seed(const Vec3<Compute>& direction) const {
        return static_cast<Vertex>(
            load(numbers(places_.seeds)[CornerDirections::place(direction)], Field::seed));
    }

  private:
    using Places = MujocoPlaces<Stored>;

    void link_neighbours(const Polyhedron& body) const {
        std::int32_t* to = numbers(places_.neighbours);
        for (Index v = 0; v < facts_.vertex_count; ++v) {
            numbers(places_.in_mesh)[v] = static_cast<std::int32_t>(v);
            numbers(places_.begins)[v] = static_cast<std::int32_t>(to - numbers(places_.neighbours));
            for (const HalfEdge h : body.ring_of_vertex(v)) *to++ = static_cast<std::int32_t>(body.head(h));
            *to++ = -1;
        }
    }
    void link_triangles(const Polyhedron& body) const {
        std::int32_t* to = numbers(places_.triangles);
        for (Index f = 0; f < facts_.face_count; ++f) {
            const auto ring = body.ring_of_face(f);
            for (std::size_t i = 1; i + 1 < ring.size(); ++i)
                for (const HalfEdge corner : {ring[0], ring[i], ring[i + 1]})
                    *to++ = static_cast<std::int32_t>(body.tail(corner));
        }
    }

    [[nodiscard]] auto* points() const { return this->template array<Vec3<Stored>>(places_.points); }
    [[nodiscard]] std::int32_t* numbers(std::uint32_t at) const {
        return this->template array<std::int32_t>(at);
    }
};

}  // namespace edgewise
