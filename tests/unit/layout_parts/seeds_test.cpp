// SPDX-License-Identifier: MIT
//
// Seeds compared with a plain maximum over all vertices; and the steps that they save a cold query.
#include "edgewise/layout_parts/seeds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/lean_seeds.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

/// layout_parts may not include algorithms, so each has a number for itself: a cold climb asks a table of so
/// many vertices for a seed, and the table has one by then.
static_assert(seeds_from <= scan_cold_below<lean_seeds<f64>>);

/// Directions of the set are their own places; of any others the place's direction is at most so far away.
template <class Directions>
void expect_near_places(double most_radians) {
    scene::Rng rng(1);
    double worst = 0;
    std::set<Index> places;
    for (int i = 0; i < 40000; ++i) {
        const Vec3d direction = rng.on_sphere() * std::exp2(rng.uniform(-60, 60));
        const Index place = Directions::place(direction);
        ASSERT_LT(place, Directions::count);
        ASSERT_LT(Directions::place(cast<float>(direction)), Directions::count);
        places.insert(place);
        const Vec3d axis = Directions::direction(place);
        const double cosine = dot(direction, axis) / norm(direction) / norm(axis);
        worst = std::max(worst, std::acos(std::min(1.0, cosine)));
    }
    std::printf("%zu directions: farthest from its place %.3f rad\n", Directions::count, worst);
    EXPECT_LT(worst, most_radians);
    const std::size_t real = Directions::count == 27 ? 26 : Directions::count;
    EXPECT_EQ(places.size(), real) << "each is the place of some";
    for (Index i = 0; i < Directions::count; ++i)
        EXPECT_EQ(Directions::place(Directions::direction(i)), i) << Directions::count;
}

TEST(Seeds, ADirectionsPlaceIsNearIt) {
    expect_near_places<CornerDirections>(0.53);
    expect_near_places<RingDirections<7>>(0.29);    // half a diagonal of 22.5 degrees: 0.278
    expect_near_places<RingDirections<15>>(0.145);  // of 11.25
    expect_near_places<GridDirections<16>>(0.09);   // of a sixteenth of 2, one from the middle: 0.088
}

template <class Directions>
void expect_a_place() {
    const double huge = std::numeric_limits<double>::infinity(),
                 none = std::numeric_limits<double>::quiet_NaN();
    for (const double x : {0.0, -0.0, 1e-320, 1e300, huge, -huge, none})
        for (const double y : {0.0, 1.0, -1e-310, huge, none})
            for (const double z : {0.0, -1.0, 1e308, none})
                EXPECT_LT(Directions::place(Vec3d(x, y, z)), Directions::count);
}

TEST(Seeds, EveryDirectionHasAPlace) {
    expect_a_place<CornerDirections>();
    expect_a_place<RingDirections<7>>();
    expect_a_place<RingDirections<15>>();
    expect_a_place<GridDirections<16>>();
}

template <class Table, class Directions>
void expect_highest(const Polyhedron& body) {
    const Table table(body, Parts::features);
    for (Index place = 0; place < Directions::count; ++place) {
        const auto direction = cast<ComputeOf<Table>>(Directions::direction(place));
        if (direction == Vec3<ComputeOf<Table>>::Zero()) continue;
        const auto height = [&](Index v) { return dot(table.vertex(v), direction); };
        const Index seed = table.seed(direction);
        ASSERT_LT(seed, body.vertex_count());
        for (Index v = 0; v < body.vertex_count(); ++v) EXPECT_LE(height(v), height(seed)) << place;
    }
}

TEST(Seeds, AreTheFarthestVertices) {
    for (const char* shape : {"sphere38", "sphere386", "sphere1538"}) {  // 8 and 16 bits
        const Polyhedron body = scene::make_shape(shape).or_throw();
        expect_highest<lean_seeds<f64>, CornerDirections>(body);
        expect_highest<lean_seeds114<f64>, RingDirections<7>>(body);
        expect_highest<lean_seeds482<f64>, RingDirections<15>>(body);
        expect_highest<lean_seeds1536<f64>, GridDirections<16>>(body);
        expect_highest<lean_seeds<f32>, CornerDirections>(stored_body<lean_seeds<f32>>(body).or_throw());
    }
}

/// From pose to pose of a body next to its copy, in any orientation, from almost touching to a body's size
/// between them: each query starts where the last one ended, far off. Raw V-Clip walks from there.
template <class Table>
double mean_steps_from_far_off(const Polyhedron& body, const QueryOptions& options = {}) {
    const Table table(body, Parts::features);
    FeaturePair<Table, Table> pair(table, table);
    scene::Rng rng(2);
    double steps = 0;
    constexpr int count = 500;
    for (int i = 0; i < count; ++i) {
        Transform<double> pose;
        pose.rotation = rng.rotation();
        pose.translation = rng.on_sphere() * rng.uniform(2.01, 4);
        const Distance answer = VClip::query(table, table, pose, pair, options);
        EXPECT_EQ(answer.status, Status::separated);
        steps += answer.steps;
    }
    return steps / count;
}

TEST(Seeds, SaveAVClipThatStartsFarOffMostOfItsWalk) {
    for (const char* shape : {"sphere38", "sphere386", "sphere1538"}) {
        const Polyhedron body = scene::make_shape(shape).or_throw();
        const double with = mean_steps_from_far_off<lean_seeds<f64>>(body);
        const double walked = mean_steps_from_far_off<lean_seeds<f64>>(body, {.hardened = false});
        std::printf("%s: %.1f states with seeds, %.1f of raw V-Clip\n", shape, with, walked);
        EXPECT_LT(with, 10) << shape;
        EXPECT_LT(with, 0.3 * walked) << shape;
    }
}

}  // namespace
}  // namespace edgewise
