// SPDX-License-Identifier: MIT
//
// The convex hull of Jitter Physics 2 (jitterphysics2, revision abaf3e1d): a vertex is its coordinates and,
// as two numbers of 16 bits, the begin and end of its neighbours in one list of 16-bit vertex indices. In
// single a vertex is 16 bytes, 9.4 bytes per edge; in double it is 32, including 4 bytes of padding for
// 8-byte coordinates. Only the structure is the engine's, from its published list of fields; the algorithms
// are ours.
//
// Departures: neighbours are in cyclic order, as in every table here, so that V-Clip walks on it with planes
// derived as in `lean`; the engine's list of triangles (4 bytes per edge more), which neither algorithm
// reads, is left out. 16 bits count 65 535 neighbours, two per edge: larger bodies are refused
// (most_neighbours, table/stored_body.hpp).
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "edgewise/layout_parts/derived/derived_table.hpp"

namespace edgewise {

template <class Stored>
struct JitterVertex {
    Vec3<Stored> point;
    std::uint16_t first, end;  ///< range of its neighbours in the list of all neighbours
};

/// The vertices' coordinates, in the form that DerivedTable needs.
template <class Stored>
struct JitterPoints {
    using Vertex = JitterVertex<Stored>;

    static void place(BlockPlan& plan, const BodyFacts& n) {
        plan.array_at<Vertex>(n.vertex_count, {{Component::vertex_coordinates, sizeof(Vec3<Stored>)},
                                               {Component::topology, 2 * sizeof(std::uint16_t)}});
    }
    static void write(std::byte* base, const Polyhedron& body) {
        auto* const to = reinterpret_cast<Vertex*>(base);
        for (Index v = 0; v < body.vertex_count(); ++v) to[v].point = cast<Stored>(body.vertices[v]);
    }
    template <class Loader>
    [[nodiscard]] static const Vec3<Stored>& read(const Loader& loader, const std::byte* base, Index v) {
        return loader.load(reinterpret_cast<const Vertex*>(base)[v].point, Field::vertex);
    }
};

/// Reads rings: bounds from the vertices, neighbours from their list.
template <class Stored>
class JitterRings : public RingSteps<JitterRings<Stored>> {
  public:
    using Vertex = JitterVertex<Stored>;

    JitterRings(Vertex* vertices, std::uint16_t* neighbours) : vertices_(vertices), neighbours_(neighbours) {}

    void fill(const Polyhedron& body) const {
        assert(body.vertex_ring.size() <= 0xffff && "stored_body refuses larger ones");
        for (Index v = 0; v < body.vertex_count(); ++v) {
            vertices_[v].first = static_cast<std::uint16_t>(body.vertex_offset[v]);
            vertices_[v].end = static_cast<std::uint16_t>(body.vertex_offset[v + 1]);
        }
        for (std::size_t i = 0; i < body.vertex_ring.size(); ++i)
            neighbours_[i] = static_cast<std::uint16_t>(body.head(body.vertex_ring[i]));
    }

    template <class Loader>
    [[nodiscard]] Index first(const Loader& loader, Index v) const {
        return loader.load(vertices_[v].first, Field::vertex_ring);
    }
    template <class Loader>
    [[nodiscard]] Index last(const Loader& loader, Index v) const {
        return loader.load(vertices_[v].end, Field::vertex_ring);
    }
    template <class Loader>
    [[nodiscard]] Index neighbour(const Loader& loader, Index /*v*/, Index at) const {
        return loader.load(neighbours_[at], Field::neighbour);
    }

  private:
    Vertex* vertices_;
    std::uint16_t* neighbours_;
};

/// Places of the rings in the block; vertices lie at its start.
template <class Stored>
class JitterRingPlaces {
  public:
    void place(BlockPlan& plan, const BodyFacts& n) {
        at_ = plan.array_at<std::uint16_t>(n.neighbour_count, {{Component::topology, sizeof(std::uint16_t)}});
    }
    [[nodiscard]] JitterRings<Stored> in(std::byte* base) const {
        return {reinterpret_cast<JitterVertex<Stored>*>(base), reinterpret_cast<std::uint16_t*>(base + at_)};
    }

  private:
    std::uint32_t at_ = 0;
};

template <Precision P, class Loader = Direct>
class jitter2
    : public DerivedTable<JitterPoints<typename P::Stored>, P, Loader, JitterRingPlaces<typename P::Stored>> {
    using Base =
        DerivedTable<JitterPoints<typename P::Stored>, P, Loader, JitterRingPlaces<typename P::Stored>>;

  public:
    static constexpr std::string_view name = "jitter2";
    static constexpr std::string_view stores =
        "Jitter2's hull (abaf3e1d): coordinates and where neighbours begin and end, 16-bit neighbours";
    static constexpr std::size_t most_neighbours = 0xffff;

    using Base::Base;
};

}  // namespace edgewise
