// SPDX-License-Identifier: MIT
//
// Where to begin: for each of 26 directions, along the axes, the edges and the corners of a cube, the vertex
// farthest along it. A cold climb or walk over some hundred vertices then starts a few steps from its end.
// MuJoCo keeps the same beside its meshes ("extrema"), PhysX 1536 of them ("Gauss map").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/layout_parts/narrow_rings.hpp"
#include "edgewise/table/body_facts.hpp"

namespace edgewise {

/// 27 places, of which the one in the middle is for no direction: its seed is vertex 0.
inline constexpr std::size_t seed_count = 27;

/// Smaller bodies have no seeds: they are scanned in less time than a seed takes.
inline constexpr std::size_t seeds_from = 32;

/// The place of the direction, of any length, among the seeds: a component counts if it is beyond
/// tan(pi / 8) of the longest, half way between an axis and a diagonal. Neither division nor root.
template <class Scalar>
[[nodiscard]] Index seed_place(const Vec3<Scalar>& direction) {
    const Scalar least = Scalar(0.41421356) * max_abs(direction);
    const auto third = [least](Scalar x) {
        return static_cast<int>(x > least) - static_cast<int>(x < -least);
    };
    return static_cast<Index>(13 + 9 * third(direction.x()) + 3 * third(direction.y()) +
                              third(direction.z()));
}

/// Points (as DerivedTable asks for them) with seeds behind them.
template <class Points>
class Seeded : public Points {
  public:
    void place(BlockPlan& plan, const BodyFacts& n) {
        Points::place(plan, n);
        const bool any = n.vertex_count >= seeds_from;
        const NarrowPlace seeds(plan, any ? seed_count : 0, n.vertex_count - 1);
        at_ = seeds.at;
        width_ = seeds.width;
    }

    void write(std::byte* base, const Polyhedron& body) {
        Points::write(base, body);
        if (body.vertex_count() < seeds_from) return;
        std::array<Vec3d, seed_count> directions;
        for (int i = 0; i < 27; ++i) directions[i] = Vec3d(i / 9 - 1, i / 3 % 3 - 1, i % 3 - 1);
        NarrowArray(base + at_, width_).fill(seed_count, [&](Index i) {
            return farthest(body, directions[i]);
        });
    }

    template <class Loader, class Scalar>
    [[nodiscard]] Index seed(const Loader& loader, std::byte* base, const Vec3<Scalar>& direction) const {
        return NarrowArray(base + at_, width_).read(loader, seed_place(direction), Field::seed);
    }

  private:
    [[nodiscard]] static Index farthest(const Polyhedron& body, const Vec3d& direction) {
        Index best = 0;
        for (Index v = 1; v < body.vertex_count(); ++v) {
            if (dot(body.vertices[v], direction) > dot(body.vertices[best], direction)) best = v;
        }
        return best;
    }

    std::uint32_t at_ = 0;
    std::uint8_t width_ = 1;
};

}  // namespace edgewise
