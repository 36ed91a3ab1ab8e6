// SPDX-License-Identifier: MIT
//
// The vertex found through boxes is the one that a look at every vertex finds: on spheres, flat and far-off
// bodies, for planes that graze them by rounding steps.
#include "edgewise/geometry/hull/vertex_boxes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace edgewise {
namespace {

std::optional<Index> first_of_all(const std::vector<Vec3d>& vertices, const Plane<double>& plane,
                                  double height) {
    for (Index v = 0; v < vertices.size(); ++v) {
        if (!(plane.distance(vertices[v]) <= height)) return v;
    }
    return {};
}

/// On an ellipsoid with these half axes around `centre`.
std::vector<Vec3d> ellipsoid(std::size_t count, const Vec3d& axes, const Vec3d& centre,
                             std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::vector<Vec3d> points(count);
    for (Vec3d& point : points) {
        point = Vec3d(normal(random), normal(random), normal(random)).normalized();
        point = centre + point.cwiseProduct(axes);
    }
    return points;
}

TEST(VertexBoxes, FindWhatALookAtAllFinds) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    int none = 0, some = 0;
    for (const std::size_t count : {1, 4, 17, 97, 1000, 6000}) {
        for (const Vec3d& axes :
             {Vec3d(1, 1, 1), Vec3d(1, 1e-9, 3), Vec3d(0, 1, 0), Vec3d(1e-30, 2e-30, 1e-30)}) {
            for (const double offset : {0.0, 1e6}) {
                const std::vector<Vec3d> vertices = ellipsoid(count, axes, Vec3d::Constant(offset), random);
                const VertexBoxes boxes(vertices);
                for (int i = 0; i < 60; ++i) {
                    const Vec3d direction =
                        Vec3d(normal(random), normal(random), normal(random)).normalized();
                    Plane<double> plane{direction, 0};
                    double highest = -std::numeric_limits<double>::infinity();
                    for (const Vec3d& v : vertices) highest = std::max(highest, plane.distance(v));
                    // Through the highest vertex, a few rounding steps over or under it, or well inside.
                    plane.offset = i % 6 == 5 ? -0.7 * highest : -highest * (1 + (i % 6 - 2) * 0x1p-52);
                    const auto expected = first_of_all(vertices, plane, 0);
                    ASSERT_EQ(boxes.first_above(plane, 0), expected) << count << ' ' << axes.transpose();
                    ++(expected ? some : none);
                }
            }
        }
    }
    std::printf("%d planes with a vertex above, %d without\n", some, none);
    EXPECT_GT(none, 100);
    EXPECT_GT(some, 100);
}

TEST(VertexBoxes, CountsWhatIsNoNumberAsAbove) {
    const std::vector<Vec3d> vertices(40, Vec3d(1, 2, 3));
    const VertexBoxes boxes(vertices);
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(boxes.first_above({Vec3d(1, 0, 0), none}, 0), Index{0});
    EXPECT_EQ(boxes.first_above({Vec3d(none, 0, 0), -9}, 0), Index{0});
    EXPECT_EQ(boxes.first_above({Vec3d(1, 0, 0), -9}, 0), std::nullopt);
}

}  // namespace
}  // namespace edgewise
