// SPDX-License-Identifier: MIT
//
// Shapes that break their contract: a query ends all the same. Where assertions are on, they say so first.
#include <gtest/gtest.h>

#include <cmath>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/geometry/tolerance.hpp"

namespace edgewise {
namespace {

/// One vertex that is nearer each time it is asked for, so that every support point is a new best one.
struct Approaching {
    using PrecisionType = f64;
    using Vertex = int;

    mutable int asked = 0;

    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Vec3d vertex(Vertex v) const { return {1 + 1 / std::sqrt(1.0 + v), 0, 0}; }
    [[nodiscard]] auto all_vertices() const {
        ++asked;
        const auto only = static_cast<std::uint32_t>(asked);
        return IndexedRing(only, only + 1, [](std::uint32_t at) { return static_cast<int>(at); });
    }
};

/// A circle of vertices; the next one always lies farther along than the last.
struct Endless {
    using PrecisionType = f64;
    using Vertex = std::uint32_t;

    mutable double height = 0;

    [[nodiscard]] std::size_t vertex_count() const { return 12; }
    [[nodiscard]] bool strictly_convex() const { return true; }
    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Vec3d vertex(Vertex) const { return {height += 1, 0, 0}; }
    [[nodiscard]] auto all_vertices() const { return index_range(12); }
    [[nodiscard]] auto neighbours(Vertex v) const {
        return IndexedRing(v + 1, v + 2, [](std::uint32_t at) { return at % 12; });
    }
};

struct Origin {
    using PrecisionType = f64;
    using Vertex = std::uint32_t;

    [[nodiscard]] Vertex first_vertex() const { return 0; }
    [[nodiscard]] Vec3d vertex(Vertex) const { return Vec3d::Zero(); }
    [[nodiscard]] auto all_vertices() const { return index_range(1); }
};

const Transform<double> in_place{Mat3d::Identity(), Vec3d::Zero()};

TEST(LyingShape, GjkGivesUp) {
    const Approaching shape;
    const Origin origin;
    SimplexPair<Approaching, Origin> pair(shape, origin);
    Distance answer{.steps = most_gjk_iterations};  // where the query dies, it stays like this
    EXPECT_DEBUG_DEATH(answer = Gjk::query(shape, origin, in_place, pair), "does not converge");
    EXPECT_EQ(answer.status, Status::failed);
    EXPECT_EQ(answer.distance, 0);
    EXPECT_EQ(pair.count(), 0U) << "the next query starts cold";
    EXPECT_EQ(answer.steps, most_gjk_iterations);
}

TEST(LyingShape, AClimbIsCutShort) {
    const Endless shape;
    SupportPoint<Endless> found{};
    EXPECT_DEBUG_DEATH(found = climb_support(shape, {1, 0, 0}, 0U), "a climb passed more vertices");
    EXPECT_LT(shape.height, 100);
    EXPECT_LT(found.along, 100);
}

}  // namespace
}  // namespace edgewise
