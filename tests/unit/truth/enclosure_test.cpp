// SPDX-License-Identifier: MIT
//
// The proof that the origin is inside a tetrahedron, against exact volumes: never given where it is not,
// however flat; always where it is by more than the error.
//
// The paper's control against the exact verdict: on random pairs they agree wherever the pair is not a matter
// of rounding, each of its three tests is needed for some pair, and what it cannot see is what its source
// says.
#include "edgewise/truth/filter/float_proof.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/integer_vector.hpp"
#include "edgewise/truth/moore_wilhelms.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

using Corners = std::array<Vec3d, 4>;

/// By signs of exact volumes, in units of 2^-200.
bool encloses_exactly(const Corners& corners) {
    std::array<IntegerVec, 4> p;
    for (int i = 0; i < 4; ++i) p[i] = scaled(corners[i], -200);
    const int side = sgn(dot(p[1], cross(p[2], p[3])));
    return side != 0 && sgn(dot(p[0], cross(p[2], p[3]))) == -side &&
           sgn(dot(p[0], cross(p[1], p[3]))) == side && sgn(dot(p[0], cross(p[1], p[2]))) == -side;
}

/// Corners up to about 1 long, squeezed along z, with the origin near a face.
Corners corners(RandomBodies& random) {
    Corners p;
    const double flat = std::ldexp(1.0, -static_cast<int>(random.bits()() % 40));
    for (Vec3d& v : p) v = {random.number(), random.number(), flat * random.number()};
    if (random.bits()() % 2 == 0) {  // a mean of three corners, a little in or out
        const Vec3d foot = (p[0] + p[1] + p[2]) / 3;
        const double in = std::ldexp(random.number(), -static_cast<int>(random.bits()() % 55));
        const Vec3d near = foot + in * (p[3] - foot);
        for (Vec3d& v : p) v -= near;
    }
    return p;
}

TEST(Enclosure, IsNeverSureOfWhatIsNotSo) {
    RandomBodies random(1);
    int enclosed = 0, sure = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Corners p = corners(random);
        const bool truly = encloses_exactly(p), says = surely_encloses_origin(p, 0);
        enclosed += truly;
        sure += says;
        ASSERT_TRUE(truly || !says) << i;
    }
    std::printf("%d of 20000 enclose the origin, sure of %d\n", enclosed, sure);
    EXPECT_GT(enclosed, 3000);
    EXPECT_GT(sure, enclosed / 2);
}

TEST(Enclosure, AllowsForTheErrorOfTheCorners) {
    RandomBodies random(2);
    int sure = 0;
    for (int i = 0; i < 20'000; ++i) {
        const Corners p = corners(random);
        const double error = std::ldexp(1.0, -8 - static_cast<int>(random.bits()() % 30));
        if (!surely_encloses_origin(p, error)) continue;
        ++sure;
        for (int k = 0; k < 20; ++k) {
            Corners moved = p;
            for (Vec3d& v : moved) v += error * random.unit();
            ASSERT_TRUE(encloses_exactly(moved)) << i;
        }
    }
    EXPECT_GT(sure, 100);
}

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
