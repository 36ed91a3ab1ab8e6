// SPDX-License-Identifier: MIT
//
// The proof that the origin is inside a tetrahedron, against exact volumes: never given where it is not,
// however flat; always where it is by more than the error.
#include "edgewise/truth/filter/float_proof.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/integer_vector.hpp"
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

TEST(Enclosure, FindsItsOwnTetrahedron) {
    const Corners p = {Vec3d(1, 1, 1), Vec3d(1, -1, -1), Vec3d(-1, 1, -1), Vec3d(-1, -1, 1)};
    EXPECT_TRUE(surely_encloses_origin(p, 0));
    EXPECT_TRUE(surely_encloses_origin({p[1], p[0], p[2], p[3]}, 0));
    EXPECT_FALSE(surely_encloses_origin(p, 1));
    Corners aside = p;
    for (Vec3d& v : aside) v.x() += 2;
    EXPECT_FALSE(surely_encloses_origin(aside, 0));
}

}  // namespace
}  // namespace edgewise::truth
