// SPDX-License-Identifier: MIT
//
// Raw V-Clip on cubes side by side, from far apart to as near as rounding: it never asks GJK, and it is the
// hardened one wherever that doubts nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

/// From features that are not a cold pair's, which the hardened walk leaves for nearer ones.
Distance ask_cubes(const ReferenceTable& cube, const Transform<double>& pose, bool hardened) {
    const auto last = Feature<ReferenceTable>::of_vertex(7), first = Feature<ReferenceTable>::of_vertex(0);
    FeaturePair<ReferenceTable, ReferenceTable> pair(cube, cube, {last, first});
    return VClip::query(cube, cube, pose, pair, {.hardened = hardened});
}

TEST(RawWalk, NeverAsksGjkAndIsElseTheHardenedOne) {
    const Polyhedron body = *scene::make_shape("cube8");
    const ReferenceTable cube(body);
    scene::Rng rng(7);
    int doubted = 0, alike = 0;
    for (int i = 0; i < 400; ++i) {
        const double gap = std::pow(10.0, -16 * rng.uniform());
        const double along = 2 * max_abs(body.vertices[0]) + gap;
        const Transform<double> pose{Mat3d::Identity(), {along, 0.3 * rng.uniform(), 0.3 * rng.uniform()}};
        const Distance hardened = ask_cubes(cube, pose, true), raw = ask_cubes(cube, pose, false);
        EXPECT_EQ(raw.fallbacks + raw.refinements, 0);
        EXPECT_EQ(raw.steps, hardened.steps);
        EXPECT_EQ(raw.cycles, hardened.cycles);
        if (hardened.fallbacks + hardened.refinements > 0) {
            ++doubted;
        } else if (gap > 1e-6) {  // and too far for rounding to take it for contact
            ++alike;
            EXPECT_EQ(raw.status, hardened.status);
            EXPECT_EQ(raw.distance, hardened.distance);
            EXPECT_EQ(raw.normal, hardened.normal);
        }
    }
    std::printf("%d doubted, %d alike\n", doubted, alike);
    EXPECT_GT(doubted, 20);
    EXPECT_GT(alike, 100);
}

}  // namespace
}  // namespace edgewise
