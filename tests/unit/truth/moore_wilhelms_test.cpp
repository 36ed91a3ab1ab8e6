// SPDX-License-Identifier: MIT
//
// The paper's control against the exact verdict: on random pairs they agree wherever the pair is not a matter
// of rounding, each of its three tests is needed for some pair, and what it cannot see is what its source
// says.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/moore_wilhelms.hpp"

namespace edgewise::truth {
namespace {

Polyhedron box(double x, double y, double z) { return *convex_hull(scene::hard::Maker::box(x, y, z)); }

bool contact(const Polyhedron& a, const Polyhedron& b, const Pose& pose_b) {
    return moore_wilhelms(a, b, relative_pose(Pose{}, pose_b)).value();
}

TEST(MooreWilhelms, AgreesWithTheExactVerdict) {
    scene::hard::Maker maker(31, false, {});
    int separated = 0, overlapping = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto a = convex_hull(maker.any_solid()), b = convex_hull(maker.any_solid());
        ASSERT_TRUE(a && b);
        const Pose pose_a{maker.rng.rotation(), Vec3d::Zero()};
        const Pose pose_b{maker.rng.rotation(), maker.rng.in_cube(1.5)};
        const auto exact = exact_distance(a->vertices, pose_a, b->vertices, pose_b);
        const bool apart = exact->verdict == ExactVerdict::separated;
        if (apart && exact->distance < 1e-12) continue;
        EXPECT_EQ(moore_wilhelms(*a, *b, relative_pose(pose_a, pose_b)), !apart) << i;
        ++(apart ? separated : overlapping);
    }
    std::printf("%d separated, %d overlapping\n", separated, overlapping);
    EXPECT_GT(separated, 300);
    EXPECT_GT(overlapping, 300);
}

TEST(MooreWilhelms, NeedsEachOfItsTests) {
    const Polyhedron cube = box(1, 1, 1), small = box(0.25, 0.25, 0.25), beam = box(3, 0.5, 0.5);
    EXPECT_TRUE(contact(cube, small, {})) << "vertices: one inside the other";
    EXPECT_TRUE(contact(cube, beam, {})) << "edges: a beam through a cube has no vertex inside";
    const Polyhedron prism = box(1, 1, 2);
    EXPECT_TRUE(contact(prism, prism, {Mat3d::Identity(), Vec3d(0, 0, 1)}))
        << "face centroids: equal cross-sections pushed into one another have only them inside";
}

TEST(MooreWilhelms, TakesTouchAndExactCopiesForApart) {
    const Polyhedron cube = box(1, 1, 1);
    EXPECT_FALSE(contact(cube, cube, {Mat3d::Identity(), Vec3d(2, 0, 0)}));
    EXPECT_FALSE(contact(cube, cube, {}));
}

}  // namespace
}  // namespace edgewise::truth
