// SPDX-License-Identifier: MIT
//
// The part of a PhysX convex hull that GJK reads (PhysX, revision a3d8a641, convex/GuBigConvexData.h,
// GuCubeIndex.h, cooking): 12-byte vertices; a vertex's valency, its number of neighbours and their
// start, 16 bits each; neighbours of 8 bits in cyclic order; and, from 32 vertices on, for each cell of a
// grid of 16 x 16 on each side of a cube the vertex farthest along its direction and the one farthest
// against it, 3072 bytes. The second half adds nothing: the farthest against a direction is the farthest
// along the opposite one. 11.4 bytes per edge at 255 vertices and 36 at 38; the engine's object has some
// 48 bytes more. Only the structure is the engine's, from its published list of fields; the algorithms
// are ours.
//
// V-Clip needs only neighbours in cyclic order: planes are derived as in `lean`. Bodies of more than 255
// vertices are refused, as in the engine. Seeds are exact maxima here.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "edgewise/layout_parts/seeds.hpp"
#include "edgewise/layouts/lean.hpp"

namespace edgewise {

struct PhysxValency {
    std::uint16_t count, first;  ///< number of neighbours, and their start in the list of all neighbours
};

using PhysxDirections = GridDirections<16>;

/// Vertices, and both halves of the table of seeds.
template <class Stored>
class PhysxPoints : public Seeded<PlainPoints<Stored>, PhysxDirections> {
    using Base = Seeded<PlainPoints<Stored>, PhysxDirections>;

  public:
    void place(BlockPlan& plan, const BodyFacts& n) {
        Base::place(plan, n);
        const bool any = n.vertex_count >= seeds_from;
        against_at_ =
            plan.array_at<std::uint8_t>(any ? PhysxDirections::count : 0, {{Component::topology, 1}});
    }
    void write(std::byte* base, const Polyhedron& body) {
        Base::write(base, body);
        if (body.vertex_count() < seeds_from) return;
        auto* const against = reinterpret_cast<std::uint8_t*>(base + against_at_);
        for (Index i = 0; i < PhysxDirections::count; ++i)
            against[i] =
                static_cast<std::uint8_t>(farthest_vertex(body, Vec3d(-PhysxDirections::direction(i))));
    }

  private:
    std::uint32_t against_at_ = 0;
};

/// Reads rings from the valencies and neighbours.
class PhysxRings : public RingSteps<PhysxRings> {
  public:
    PhysxRings(PhysxValency* valencies, std::uint8_t* neighbours)
        : valencies_(valencies), neighbours_(neighbours) {}

    void fill(const Polyhedron& body) const {
        assert(body.vertex_count() <= 0xff && "stored_body refuses larger ones");
        for (Index v = 0; v < body.vertex_count(); ++v)
            valencies_[v] = {static_cast<std::uint16_t>(body.ring_of_vertex(v).size()),
                             static_cast<std::uint16_t>(body.vertex_offset[v])};
        for (std::size_t i = 0; i < body.vertex_ring.size(); ++i)
            neighbours_[i] = static_cast<std::uint8_t>(body.head(body.vertex_ring[i]));
    }

    template <class Loader>
    [[nodiscard]] Index first(const Loader& loader, Index v) const {
        return loader.load(valencies_[v].first, Field::vertex_ring);
    }
    template <class Loader>
    [[nodiscard]] Index last(const Loader& loader, Index v) const {
        const PhysxValency valency = loader.load(valencies_[v], Field::vertex_ring);
        return Index{valency.first} + valency.count;
    }
    template <class Loader>
    [[nodiscard]] Index neighbour(const Loader& loader, Index /*v*/, Index at) const {
        return loader.load(neighbours_[at], Field::neighbour);
    }

  private:
    PhysxValency* valencies_;
    std::uint8_t* neighbours_;
};

class PhysxRingPlaces {
  public:
    void place(BlockPlan& plan, const BodyFacts& n) {
        valencies_at_ =
            plan.array_at<PhysxValency>(n.vertex_count, {{Component::topology, sizeof(PhysxValency)}});
        neighbours_at_ = plan.array_at<std::uint8_t>(n.neighbour_count, {{Component::topology, 1}});
    }
    [[nodiscard]] PhysxRings in(std::byte* base) const {
        return {reinterpret_cast<PhysxValency*>(base + valencies_at_),
                reinterpret_cast<std::uint8_t*>(base + neighbours_at_)};
    }

  private:
    std::uint32_t valencies_at_ = 0, neighbours_at_ = 0;
};

template <Precision P, class Loader = Direct>
class physx : public TableWithSeeds<PhysxPoints<typename P::Stored>, P, Loader, PhysxRingPlaces> {
    using Base = TableWithSeeds<PhysxPoints<typename P::Stored>, P, Loader, PhysxRingPlaces>;

  public:
    static constexpr std::string_view name = "physx";
    static constexpr std::string_view stores =
        "PhysX's hull for GJK (a3d8a641): coordinates, valencies, 8-bit neighbours, 1536 seeds twice";
    static constexpr std::size_t most_vertices = 255;

    using Base::Base;
};

}  // namespace edgewise
