// SPDX-License-Identifier: MIT
//
// Smaller bodies: the stated error bounds every distance, to one side, and is attained.
#include "edgewise/studies/advise/vertex_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::studies::advise {
namespace {

const std::vector<std::size_t> some_counts = {4, 6, 8, 16, 24, 64};

double distance(const Vec3d& point, const std::vector<Vec3d>& body) {
    return truth::exact_distance(std::span(&point, 1), {}, body, {})->distance;
}

TEST(VertexBudget, BoundsEveryDistanceToOneSide) {
    const Polyhedron body = *scene::make_shape("sphere98");
    scene::Rng rng(7);
    for (const SmallerBody& smaller : smaller_bodies(body, some_counts)) {
        double most = 0;
        for (int i = 0; i < 60; ++i) {
            const Vec3d point = rng.on_sphere() * rng.uniform(0.9, 3);
            const double added = distance(point, smaller.vertices) - distance(point, body.vertices);
            EXPECT_GE(added, -1e-15);
            EXPECT_LE(added, smaller.worst_error * (1 + 1e-14));
            most = std::max(most, added);
        }
        for (const Vec3d& vertex : body.vertices) most = std::max(most, distance(vertex, smaller.vertices));
        EXPECT_DOUBLE_EQ(most, smaller.worst_error) << "attained at a vertex";
    }
}

TEST(VertexBudget, NeedsFewerVerticesTheMoreErrorIsAllowed) {
    const Polyhedron body = *scene::make_shape("sphere146");
    const auto bodies = smaller_bodies(body, some_counts);
    ASSERT_EQ(bodies.size(), some_counts.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        EXPECT_EQ(bodies[i].vertices.size(), some_counts[i]);
        if (i > 0) {
            EXPECT_LE(bodies[i].worst_error, bodies[i - 1].worst_error);
        }
        for (const Vec3d& vertex : bodies[i].vertices)
            EXPECT_NE(std::ranges::find(body.vertices, vertex), body.vertices.end())
                << "a vertex of the body";
    }
}

TEST(VertexBudget, KeepsWithinTheTolerance) {
    const Polyhedron body = *scene::make_shape("sphere98");
    std::size_t last = 0;
    for (const double tolerance : {0.5, 0.2, 0.05, 1e-6}) {
        const SmallerBody fitting = within_tolerance(body, tolerance);
        EXPECT_LE(fitting.worst_error, tolerance);
        EXPECT_EQ(fitting.worst_error, worst_error_of(body.vertices, fitting.vertices));
        EXPECT_GE(fitting.vertices.size(), last);
        last = fitting.vertices.size();
    }
    EXPECT_EQ(last, 98U) << "no vertex of a sphere can be left out at 1e-6";
    EXPECT_EQ(within_tolerance(*scene::make_shape("cube8"), 0.1).vertices.size(), 8U);
}

/// Vertices that stick out by less than is allowed go, however many they are.
TEST(VertexBudget, FindsTheCubeInACubeWithBumps) {
    scene::Rng rng(3);
    std::vector<Vec3d> points = scene::make_shape("cube8")->vertices;
    for (int i = 0; i < 40; ++i) {
        Vec3d bump = rng.in_cube(0.4);
        bump[i % 3] = i % 2 ? 0.5625 + 1e-4 : -0.5625 - 1e-4;
        points.push_back(bump);
    }
    const Polyhedron body = *convex_hull(points);
    ASSERT_GT(body.vertex_count(), 20U);
    const SmallerBody fitting = within_tolerance(body, 1.5e-4);
    EXPECT_EQ(fitting.vertices.size(), 8U);
    EXPECT_NEAR(fitting.worst_error, 1e-4, 1e-12);
}

/// A regular n-gon below another.
std::vector<Vec3d> prism(int sides, double height) {
    std::vector<Vec3d> points;
    for (const double z : {0.0, height}) {
        for (int i = 0; i < sides; ++i)
            points.emplace_back(std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides), z);
    }
    return points;
}

std::vector<Vec3d> box(const Vec3d& sides) {
    std::vector<Vec3d> points;
    for (int corner = 0; corner < 8; ++corner)
        points.emplace_back(corner & 1 ? sides.x() : 0, corner & 2 ? sides.y() : 0,
                            corner & 4 ? sides.z() : 0);
    return points;
}

/// Vertices chosen as the farthest may lie in one plane here; every smaller body must still be a solid.
TEST(VertexBudget, GivesSolidsOfBoxesPrismsAndPlates) {
    std::vector<std::vector<Vec3d>> all = {scene::make_shape("cube8")->vertices, box({1, 2, 3}),
                                           box({1, 1, 5}), box({1, 1, 1e-6}), box({1e-5, 1, 1})};
    for (const int sides : {3, 4, 5, 6, 12, 32})
        for (const double height : {1e-4, 0.1, 1.0, 2.0, 10.0}) all.push_back(prism(sides, height));
    for (const std::vector<Vec3d>& points : all) {
        const auto body = convex_hull(points);
        ASSERT_TRUE(body) << body.error;
        std::vector<SmallerBody> bodies = smaller_bodies(*body, {4, 5, 6, 8, 16});
        EXPECT_FALSE(bodies.empty() && body->vertex_count() > 4);
        for (const std::size_t most : {4U, 5U, 7U}) bodies.push_back(within_count(*body, most));
        for (const double tolerance : {1e-9, 1e-3, 0.1, 0.5, 100.0})
            bodies.push_back(within_tolerance(*body, tolerance));
        for (const SmallerBody& smaller : bodies) {
            const auto hull = convex_hull(smaller.vertices);
            EXPECT_TRUE(hull) << hull.error << ": " << smaller.vertices.size() << " of " << points.size();
            EXPECT_EQ(smaller.worst_error, worst_error_of(body->vertices, smaller.vertices));
        }
    }
}

TEST(VertexBudget, KeepsToACount) {
    const Polyhedron body = *scene::make_shape("sphere98");
    double last = 2;
    for (const std::size_t most : {4U, 5U, 9U, 33U, 97U}) {
        const SmallerBody smaller = within_count(body, most);
        EXPECT_EQ(smaller.vertices.size(), most);
        EXPECT_LE(smaller.worst_error, last);
        EXPECT_GT(smaller.worst_error, 0);
        last = smaller.worst_error;
    }
    for (const std::size_t most : {98U, 99U, 1000U}) {
        EXPECT_EQ(within_count(body, most).vertices.size(), 98U);
        EXPECT_EQ(within_count(body, most).worst_error, 0);
    }
}

}  // namespace
}  // namespace edgewise::studies::advise
