// SPDX-License-Identifier: MIT
//
// Rounding a body to single precision: its own topology, the names of the original input.
#include "edgewise/geometry/hull.hpp"

#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::all_violations;
using testing::box_points;
using testing::Dice;
using testing::placed;
using testing::Points;
using testing::random_rotation;

// The expected values are spelled out, since casts in the test would go wrong the same way as casts in the
// code.
TEST(RoundToSingle, RoundsEveryCoordinate) {
    const double tenth = 0x1.99999ap-4;
    EXPECT_EQ(to_single(0.1), tenth);
    EXPECT_EQ(to_single(Vec3d(0.1, 0.2, 0.4)), Vec3d(tenth, 2 * tenth, 4 * tenth));
    const Result<Polyhedron> box = convex_hull(box_points(Vec3d(0.1, 0.2, 0.4)));
    ASSERT_TRUE(box) << box.error;
    const Result<Polyhedron> rounded = round_to_single(*box);
    ASSERT_TRUE(rounded) << rounded.error;
    EXPECT_EQ(rounded->vertices, box_points(Vec3d(tenth, 2 * tenth, 4 * tenth)));
}

TEST(RoundToSingle, LeavesRepresentableBodiesAlone) {
    const Result<Polyhedron> cube = convex_hull(box_points(Vec3d(0.5, 0.25, 3)));
    ASSERT_TRUE(cube);
    const Result<Polyhedron> rounded = round_to_single(*cube);
    ASSERT_TRUE(rounded) << rounded.error;
    EXPECT_EQ(rounded->vertices, cube->vertices);
    EXPECT_EQ(rounded->face_ring, cube->face_ring);
    EXPECT_EQ(rounded.warning, "");
}

TEST(RoundToSingle, IsTheHullOfTheRoundedVertices) {
    Dice dice(17);
    int bent = 0;
    for (int trial = 0; trial < 30; ++trial) {
        Points points = placed(box_points(Vec3d(1, 1, 1)), random_rotation(dice), dice.vector(), 1);
        points.insert(points.begin(), Vec3d(points[0] * 0.5 + points[7] * 0.5));
        const Result<Polyhedron> box = convex_hull(points);
        ASSERT_TRUE(box) << box.error;
        const Result<Polyhedron> rounded = round_to_single(*box);
        ASSERT_TRUE(rounded) << rounded.error;
        EXPECT_EQ(all_violations(*rounded), "");
        for (std::size_t v = 0; v < rounded->vertex_count(); ++v) {
            const Vec3d single = to_single(points[rounded->input_index[v]]);
            EXPECT_EQ(rounded->vertices[v], single);
        }
        bent += rounded->face_count() > 6;  // rounded corners of a tilted quad are not coplanar
    }
    EXPECT_GT(bent, 20);
}

TEST(RoundToSingle, SaysWhatSinglePrecisionLoses) {
    const Result<Polyhedron> far =
        convex_hull(placed(box_points(Vec3d(1, 1, 1)), Mat3d::Identity(), Vec3d(1e9, 0, 0), 1));
    ASSERT_TRUE(far) << far.error;
    const Result<Polyhedron> flat = round_to_single(*far);
    ASSERT_TRUE(flat) << flat.error;
    EXPECT_LT(flat->face_count(), 3U);
    EXPECT_NE(flat.warning.find("flat in single precision"), std::string::npos) << flat.warning;

    const Result<Polyhedron> huge = convex_hull(box_points(Vec3d(1e39, 1e39, 1e39)));
    ASSERT_TRUE(huge);
    const Result<Polyhedron> overflow = round_to_single(*huge);
    EXPECT_FALSE(overflow);
    EXPECT_NE(overflow.error.find("vertex 0"), std::string::npos) << overflow.error;

    Points close = box_points(Vec3d(1, 1, 1));
    close.push_back(Vec3d(1 + 1e-9, 0, 0));
    const Result<Polyhedron> roof = convex_hull(close);
    ASSERT_TRUE(roof);
    ASSERT_EQ(roof->vertex_count(), 9u);
    const Result<Polyhedron> box = round_to_single(*roof);
    ASSERT_TRUE(box) << box.error;
    EXPECT_EQ(box->vertex_count(), 8u);
    EXPECT_EQ(box.warning, "1 of 9 vertices vanish in single precision");
}

}  // namespace
}  // namespace edgewise
