// SPDX-License-Identifier: MIT
//
// Start vertices: for each of a set of directions (seed_directions.hpp) the vertex farthest along it, in 1, 2
// or 4 bytes. A cold climb or walk over some hundred vertices then starts a few steps from its end, and the
// more directions, the fewer steps.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/derived/derived_table.hpp"
#include "edgewise/layout_parts/seed_directions.hpp"

namespace edgewise {

/// Smaller bodies have no seeds: a scan of them takes less time than a seed.
inline constexpr std::size_t seeds_from = 32;

[[nodiscard]] inline Index farthest_vertex(const Polyhedron& body, const Vec3d& direction) {
    Index best = 0;
    for (Index v = 1; v < body.vertex_count(); ++v) {
        if (dot(body.vertices[v], direction) > dot(body.vertices[best], direction)) best = v;
    }
    return best;
}

/// Points (in the form that DerivedTable needs) with seeds behind them.
template <class Points, class Directions>
class Seeded : public Points {
  public:
    void place(BlockPlan& plan, const BodyFacts& n) {
        Points::place(plan, n);
        const bool any = n.vertex_count >= seeds_from;
        const NarrowPlace seeds(plan, any ? Directions::count : 0, n.vertex_count - 1);
        at_ = seeds.at;
        width_ = seeds.width;
    }

    void write(std::byte* base, const Polyhedron& body) {
        Points::write(base, body);
        if (body.vertex_count() < seeds_from) return;
        NarrowArray(base + at_, width_).fill(Directions::count, [&](Index i) {
            return farthest_vertex(body, Directions::direction(i));
        });
    }

    template <class Loader, class Scalar>
    [[nodiscard]] Index seed(const Loader& loader, std::byte* base, const Vec3<Scalar>& direction) const {
        return NarrowArray(base + at_, width_).read(loader, Directions::place(direction), Field::seed);
    }

  private:
    std::uint32_t at_ = 0;
    std::uint8_t width_ = 1;
};

/// A table that derives all features and has seeds: `Points` are Seeded.
template <class Points, Precision P, class Loader, class RingPlaces = NarrowRingPlaces>
class TableWithSeeds : public DerivedTable<Points, P, Loader, RingPlaces> {
    using Base = DerivedTable<Points, P, Loader, RingPlaces>;

  public:
    using Base::Base;

    /// Returns a vertex far along the direction (any length). Not for bodies of less than 32 vertices.
    [[nodiscard]] typename Base::Vertex seed(const Vec3<typename Base::Compute>& direction) const {
        assert(this->vertex_count() >= seeds_from);
        return this->points_.seed(this->loader_, this->block_.base(), direction);
    }
};

}  // namespace edgewise
