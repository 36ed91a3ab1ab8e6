// SPDX-License-Identifier: MIT
//
// Support points: scan and climb, from any start, compared with a plain maximum over all vertices.
#include "edgewise/algorithms/support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/linked.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/canonical.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

/// The first of the highest vertices.
Index highest(const Polyhedron& body, const Vec3d& direction) {
    Index best = 0;
    for (Index v = 1; v < body.vertex_count(); ++v) {
        if (dot(body.vertices[v], direction) > dot(body.vertices[best], direction)) best = v;
    }
    return best;
}

class Support : public ::testing::TestWithParam<std::string> {};

TEST_P(Support, ScanAndClimbFindTheHighestVertex) {
    const auto body = scene::make_shape(GetParam());
    ASSERT_TRUE(body) << body.error;
    const Canonical table(*body);
    scene::Rng rng(1);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        Vec3d direction = rng.on_sphere();
        if (i % 4 == 0) direction = (direction * 1.5).array().round();  // lattice: equal vertices
        if (i % 4 == 1) direction = body->face_planes[rng.below(body->face_count())].normal;
        const double top = dot(body->vertices[highest(*body, direction)], direction);
        const auto start = static_cast<Index>(rng.below(body->vertex_count()));
        const auto scanned = scan_support(table, direction);
        const auto climbed = climb_support(table, direction, start);
        const auto chosen = support(table, direction, start);
        EXPECT_EQ(scanned.vertex, highest(*body, direction));
        for (const auto& found : {scanned, climbed, chosen}) {
            EXPECT_EQ(found.point, body->vertices[found.vertex]);
            EXPECT_EQ(found.along, dot(found.point, direction));
            worst = std::max(worst, top - found.along);
        }
    }
    std::printf("support %s: worst shortfall %.3g\n", GetParam().c_str(), worst);
    EXPECT_LT(worst, 1e-14);  // among vertices that rounding cannot separate
}

/// Handles that are no numbers: one vertex at a time.
TEST(SupportOfNodes, ScanFindsTheHighestVertex) {
    const Polyhedron body = scene::make_shape("sphere38").or_throw();
    const linked<f64> table(body, Parts::support);
    scene::Rng rng(4);
    for (int i = 0; i < 1000; ++i) {
        const Vec3d direction = rng.on_sphere();
        EXPECT_EQ(table.index_of(scan_support(table, direction).vertex), highest(body, direction));
    }
}

/// A prism of many sides on its side: climbs along its axis meet level vertices only.
Polyhedron prism(int sides, double length) {
    std::vector<Vec3d> points;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        for (const double end : {0.0, length}) points.push_back({std::cos(angle), std::sin(angle), end});
    }
    return convex_hull(points).or_throw();
}

/// Heights of a table in single that differ by less than rounding, over short edges and long ones.
template <class Table>
double worst_climb(const Polyhedron& given) {
    using Scalar = ComputeOf<Table>;
    const Polyhedron body = stored_body<Table>(given).or_throw();
    const Table table(body, Parts::support);
    EXPECT_TRUE(table.climbable());
    scene::Rng rng(3);
    double worst = 0;
    for (int i = 0; i < 3000; ++i) {
        Vec3d direction = rng.on_sphere();
        if (i % 2 == 0) direction = body.face_planes[rng.below(body.face_count())].normal;
        if (i % 4 == 0) direction += rng.in_ball() * (i % 8 == 0 ? 1e-3 : 1e-6);
        const auto start = static_cast<Index>(rng.below(body.vertex_count()));
        const auto found = climb_support(table, cast<Scalar>(direction), start);
        const Vec3d asked = cast<double>(cast<Scalar>(direction));
        const double top = dot(body.vertices[highest(body, asked)], asked);
        worst = std::max(worst, (top - dot(body.vertices[found.vertex], asked)) / table.reach());
    }
    return worst;
}

TEST(Climb, FindsTheTopBehindLevelVertices) {
    std::vector<Polyhedron> bodies = {prism(5, 1), prism(40, 1e-3), prism(12, 3e-5), prism(100, 20)};
    // Found by fuzzing: an edge of 3e-5 that rises by less than rounding hides the whole top.
    bodies.push_back(convex_hull(std::vector<Vec3d>{{-1, -1, -1},
                                                    {1, -1, -1},
                                                    {-1, 1, -1},
                                                    {1, 1, -1},
                                                    {0, -1, 1},
                                                    {3.0524563044309616e-05, -1, 1},
                                                    {-1, 1, 1},
                                                    {1, 1, 1.0000000009313226}})
                         .or_throw());
    for (const char* shape : {"sphere386", "sphere1538", "uv_sphere386", "cube8"})
        bodies.push_back(scene::make_shape(shape).or_throw());
    double worst = 0, worst_single = 0;
    for (const Polyhedron& body : bodies) {
        worst = std::max(worst, worst_climb<lean<f64>>(body));
        worst_single = std::max(worst_single, worst_climb<lean<f32>>(body));
    }
    std::printf("worst shortfall: %.3g in double, %.3g in single\n", worst, worst_single);
    EXPECT_LT(worst, 1e-14);
    EXPECT_LT(worst_single, 2e-6);
}

struct HeightErrors {
    double worst = 0, worst_of_neighbours = 0;  ///< over the size
    int by_neighbours = 0, by_scan = 0;

    void add(const lean<f32>& table, const Vec3d& direction, Index start) {
        const auto height_of = [&](auto v) { return dot(cast<double>(table.vertex(v)), direction); };
        const double highest = scan_height(table, direction);
        ++(height_of_top(table, direction, start) ? by_neighbours : by_scan);
        worst = std::max(worst, std::abs(greatest_height(table, direction, start) - highest) / table.reach());
        bool is_top = true;
        for (const auto v : table.neighbours(start)) is_top &= height_of(v) <= height_of(start);
        if (is_top)
            worst_of_neighbours = std::max(worst_of_neighbours, (highest - height_of(start)) / table.reach());
    }
};

/// Heights of tables in single, computed in double: from the farthest vertex, those around it, and any.
TEST(GreatestHeight, OfATableInSingleIsThatOfAllVertices) {
    scene::Rng rng(6);
    for (const Polyhedron& body : {prism(5, 1), prism(12, 0.01), *scene::make_shape("sphere38"),
                                   *scene::make_shape("sphere386"), *scene::make_shape("box8")}) {
        const lean<f32> table(body, Parts::support);
        ASSERT_TRUE(table.strictly_convex());
        HeightErrors errors;
        for (int i = 0; i < 300; ++i) {
            Vec3d direction = rng.on_sphere();
            if (i % 3 == 0) direction = direction.array().round();  // level vertices
            const auto farthest = scan_support(table, cast<float>(direction)).vertex;
            errors.add(table, direction, farthest);
            errors.add(table, direction, static_cast<Index>(rng.below(table.vertex_count())));
            for (const auto v : table.neighbours(farthest)) errors.add(table, direction, v);
        }
        std::printf("%d by neighbours, %d by scan, worst error %.3g of the size\n", errors.by_neighbours,
                    errors.by_scan, errors.worst);
        EXPECT_LE(errors.worst, 2e-9);
        EXPECT_GE(std::min(errors.by_neighbours, errors.by_scan), 300);
    }
}

/// A vertex 1e-9 outside of a side that rounding to single puts inside: the side's ends have no higher
/// neighbour, and may be lower than each other.
TEST(GreatestHeight, OfABodyThatIsNotStrictlyConvexIsFoundByAScan) {
    const lean<f32> dented(
        convex_hull(
            std::vector<Vec3d>{{-1, -0.1, 1}, {0, 0.1 + 1e-9, 1}, {1, 0.3, 1}, {0, -3, 1}, {0, -1, -2}})
            .or_throw(),
        Parts::support);
    ASSERT_EQ(dented.vertex_count(), 5U);
    ASSERT_FALSE(dented.strictly_convex());
    HeightErrors errors;
    for (int i = -100; i <= 100; ++i)
        for (const Index start : dented.all_vertices())
            errors.add(dented, Vec3d(-0.2 + i * 1e-10, 1, 0), start);
    EXPECT_EQ(errors.by_neighbours, 0);
    EXPECT_EQ(errors.worst, 0);
    EXPECT_GT(errors.worst_of_neighbours, 1e-9) << "it would have been wrong";
}

INSTANTIATE_TEST_SUITE_P(Shapes, Support, ::testing::Values("tetra4", "cube8", "sphere18", "sphere386"),
                         [](const auto& shape) { return shape.param; });

}  // namespace
}  // namespace edgewise
