// SPDX-License-Identifier: MIT
//
// The bodies that a table of half extents takes and refuses, its vertices and bytes, and its support points
// compared with those that a scan of all vertices finds.
#include "edgewise/layouts/box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "edgewise/algorithms/support.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

std::vector<Vec3d> corners(const Vec3d& half) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? half[0] : -half[0], i & 2 ? half[1] : -half[1],
                            i & 4 ? half[2] : -half[2]);
    return points;
}

/// Unequal sides, a cube, a plate, a beam; huge and tiny.
const std::vector<Vec3d> sizes = {{0.875, 0.5, 0.3125}, {0.5625, 0.5625, 0.5625}, {1, 0.7, 1e-5},
                                  {3, 1e-3, 0.3},       {3e8, 1e8, 2e8},          {3e-8, 1e-8, 2e-8}};

/// The vertices in any order of the input, whose names stay.
template <class P>
void expect_held(const Vec3d& size, std::mt19937& random) {
    std::vector<Vec3d> points = corners(size);
    std::shuffle(points.begin(), points.end(), random);
    const auto body = stored_body<box<P>>(convex_hull(points).or_throw());
    ASSERT_TRUE(body) << body.error;
    const box<P> table(*body, Parts::features);
    for (const Index v : table.all_vertices()) {
        EXPECT_EQ(Vec3d(cast<double>(table.vertex(v))), body->vertices[v]);
        const Vec3d& given = points[body->input_index[v]];
        EXPECT_EQ(cast<typename P::Stored>(given), cast<typename P::Stored>(body->vertices[v]));
    }
    EXPECT_EQ(table.ledger().total(), 3 * sizeof(typename P::Stored));
    EXPECT_LE(sizeof table, 64U);
}

TEST(Box, HoldsBoxesOfEverySizeInThreeNumbers) {
    std::mt19937 random(1);
    for (const Vec3d& size : sizes) {
        SCOPED_TRACE(size.transpose());
        for (int i = 0; i < 10; ++i) {
            expect_held<f64>(size, random);
            expect_held<f32>(size, random);
        }
    }
}

TEST(Box, RefusesABoxThatIsOneBitOff) {
    const double far = std::numeric_limits<double>::infinity();
    for (const Vec3d& size : sizes) {
        Polyhedron body = convex_hull(corners(size)).or_throw();
        for (Vec3d& v : body.vertices) {
            for (double& x : v) {
                const double kept = x;
                for (const double towards : {-far, far}) {
                    x = std::nextafter(kept, towards);
                    EXPECT_FALSE(stored_body<box<f64>>(body));
                }
                x = kept;
            }
        }
        EXPECT_TRUE(stored_body<box<f64>>(body));
        body.vertices[5].y() *= 1 + 1e-15;
        EXPECT_TRUE(stored_body<box<f32>>(body)) << "single precision cannot tell";
        EXPECT_EQ(
            stored_body<box<f64>>(body).error,
            "box takes bodies of 8 vertices at (+-x, +-y, +-z) and 6 faces, and vertices 0 and 5 of this one differ in more than signs");
    }
}

TEST(Box, RefusesOtherBodies) {
    const auto error = [](const Polyhedron& body) { return stored_body<box<f64>>(body).error; };
    const std::string takes = "box takes bodies of 8 vertices at (+-x, +-y, +-z) and 6 faces, and ";
    EXPECT_EQ(error(scene::make_shape("tetra4").or_throw()), takes + "this one has 4 and 4");
    EXPECT_EQ(error(scene::make_shape("sphere8").or_throw()), takes + "this one has 8 and 12");
    EXPECT_EQ(error(hull_of_any(corners({1, 1, 0})).or_throw()), takes + "this one has 4 and 2");
    std::vector<Vec3d> points = corners({1, 2, 3});
    for (Vec3d& v : points) v.x() += 1;
    EXPECT_NE(error(convex_hull(points).or_throw()), "") << "elsewhere";
    for (Vec3d& v : points) v = {0.8 * v.x() - 0.8 - 0.6 * v.y(), 0.6 * v.x() - 0.6 + 0.8 * v.y(), v.z()};
    EXPECT_NE(error(convex_hull(points).or_throw()), "") << "turned";
}

/// A plate and a tip above it, asked twice: whatever parts were asked for, the box has faces.
TEST(Box, HasItsFacesWhateverPartsAreAskedFor) {
    const auto plate = stored_body<box<f64>>(convex_hull(corners({10, 10, 0.1})).or_throw()).or_throw();
    const std::vector<Vec3d> tip = {{0, 1, 2}, {1, -1, 2}, {-1, -1, 2}, {0.1, 0.2, 1}};
    const lean<f64> above(convex_hull(tip).or_throw(), Parts::features);
    for (const Parts parts : {Parts::support, Parts::features}) {
        const box<f64> table(plate, parts);
        FeaturePair<box<f64>, lean<f64>> pair(table, above);
        for (int i = 0; i < 2; ++i)
            EXPECT_NEAR(VClip::query(table, above, relative_pose(Pose{}, Pose{}), pair).distance, 0.9, 1e-15);
    }
}

/// On a lattice vertices are level; a side below the rounding step of another is absorbed.
TEST(Box, FindsTheSupportPointsOfAScan) {
    scene::Rng rng(2);
    for (const Vec3d& size : sizes) {
        const Polyhedron body = stored_body<box<f64>>(convex_hull(corners(size)).or_throw()).or_throw();
        const box<f64> table(body, Parts::support);
        const lean<f64> plain(body, Parts::support);
        for (int i = 0; i < 1000; ++i) {
            Vec3d direction = rng.in_cube(2.5);
            if (i % 3 == 0) direction = direction.array().round();
            if (i % 3 == 1) direction[i % 9 / 3] *= std::ldexp(1.0, -40 - i % 30);
            const auto found = scan_support(table, direction);
            const auto expected = scan_any(plain, direction);
            EXPECT_EQ(found.vertex, expected.vertex) << direction.transpose();
            EXPECT_EQ(found.along, expected.along);
            EXPECT_EQ(table.scan_height(direction), expected.along);
        }
    }
}

}  // namespace
}  // namespace edgewise
