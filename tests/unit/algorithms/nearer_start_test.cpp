// SPDX-License-Identifier: MIT
//
// V-Clip's cold starts, and those of pairs that moved far: few steps from the vertices that face each other,
// compared with raw V-Clip, which walks from the first vertices or the last features; the same distance.
#include "edgewise/algorithms/vclip/nearer_start.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/box.hpp"
#include "edgewise/layouts/lean_seeds.hpp"
#include "edgewise/layouts/linked.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

struct ColdSteps {
    int queries = 0, cold = 0, raw = 0;
    double worst = 0;  ///< difference of distances
};

template <class Table>
ColdSteps ask_cold(const char* shape) {
    const Table table(*scene::make_shape(shape), Parts::features);
    scene::Rng rng(21);
    ColdSteps steps;
    for (int i = 0; i < 400; ++i) {
        const Transform<double> pose{rng.rotation(), rng.on_sphere() * rng.uniform(1.8, 4)};
        FeaturePair<Table, Table> pair(table, table), raw_pair(table, table);
        const Distance answer = VClip::query(table, table, pose, pair);
        const Distance raw = VClip::query(table, table, pose, raw_pair, {.hardened = false});
        if (answer.status != Status::separated || raw.status != Status::separated || raw.cycles > 0) continue;
        ++steps.queries;
        steps.cold += answer.steps;
        steps.raw += raw.steps;
        steps.worst = std::max(steps.worst, std::abs(answer.distance - raw.distance));
    }
    std::printf("%s: %d queries, steps %.2f, raw %.2f, worst difference %.3g\n", shape, steps.queries,
                static_cast<double>(steps.cold) / steps.queries,
                static_cast<double>(steps.raw) / steps.queries, steps.worst);
    return steps;
}

/// From facing vertices most walks go to an edge and on to a face or another edge.
template <class Table>
void expect_short_walks(double most_difference) {
    for (const char* shape : {"cube8", "sphere38", "sphere386"}) {
        const ColdSteps steps = ask_cold<Table>(shape);
        EXPECT_GT(steps.queries, 200);
        EXPECT_LT(steps.cold, 4.5 * steps.queries) << shape;
        EXPECT_LT(steps.cold, 0.6 * steps.raw) << shape;
        EXPECT_LT(steps.worst, most_difference);
    }
}

TEST(NearerStart, ShortensColdWalks) { expect_short_walks<aos<f64>>(1e-13); }
TEST(NearerStart, FromSeedsInSingle) { expect_short_walks<lean_seeds<f32>>(1e-4); }
TEST(NearerStart, OverPointers) { expect_short_walks<linked<f64>>(1e-13); }

struct FarSteps {
    int queries = 0, steps = 0, again = 0, raw = 0;  ///< again: steps of the query, asked twice
    int far = 0, on = 0;                             ///< pairs that note nearer_start, walk_on
    double worst = 0;                                ///< difference of distances
};

/// Asks one pair and one of raw V-Clip in pose after pose.
template <class Table, class NextRotation>
FarSteps ask_moving(const Polyhedron& body, NextRotation next) {
    const Table table(*stored_body<Table>(body), Parts::features);
    scene::Rng rng(23);
    FeaturePair<Table, Table> pair(table, table), raw_pair(table, table);
    FarSteps all;
    Transform<double> pose{rng.rotation(), Vec3d(2.4, 0, 0)};
    for (int i = 0; i < 1000; ++i) {
        pose.rotation = next(rng, pose.rotation);
        const Distance answer = VClip::query(table, table, pose, pair);
        const Distance raw = VClip::query(table, table, pose, raw_pair, {.hardened = false});
        if (answer.status != Status::separated || raw.status != Status::separated || raw.cycles > 0) continue;
        ++all.queries;
        all.steps += answer.steps;
        all.raw += raw.steps;
        all.far += pair.first_try() == FirstTry::nearer_start;
        all.on += pair.first_try() == FirstTry::walk_on;
        FeaturePair<Table, Table> at_rest = pair;
        all.again += VClip::query(table, table, pose, at_rest).steps;
        all.worst = std::max(all.worst, std::abs(answer.distance - raw.distance));
    }
    std::printf("%d queries, steps %.2f, raw %.2f, %d moved far, %d walk on, worst difference %.3g\n",
                all.queries, 1.0 * all.steps / all.queries, 1.0 * all.raw / all.queries, all.far, all.on,
                all.worst);
    EXPECT_GT(all.queries, 500);
    EXPECT_LT(all.worst, 1e-13);
    return all;
}

/// In any pose the last features are no start. The pair knows after the first long walk.
TEST(NearerStart, ShortensWalksInAnyPose) {
    for (const char* shape : {"cube8", "sphere38", "sphere386"}) {
        const auto any = [](scene::Rng& rng, const Mat3d&) { return rng.rotation(); };
        const FarSteps all = ask_moving<aos<f64>>(*scene::make_shape(shape), any);
        EXPECT_LT(all.steps, 0.6 * all.raw);
        EXPECT_GT(all.far, 0.7 * all.queries);
    }
}

/// Turns by this angle about any axis, and every hundredth time to any orientation.
auto turning_by(double angle) {
    return [angle, turns = 0](scene::Rng& rng, const Mat3d& before) mutable -> Mat3d {
        if (++turns % 100 == 1) return rng.rotation();
        return Eigen::AngleAxisd(angle, rng.on_sphere()).toRotationMatrix() * before;
    };
}

/// Bodies that hardly turn start from their last features, also after a large turn.
TEST(NearerStart, IsNotLookedForAfterSmallMotion) {
    for (const char* shape : {"cube8", "sphere38", "sphere386"}) {
        const FarSteps all = ask_moving<aos<f64>>(*scene::make_shape(shape), turning_by(0.01));
        EXPECT_LT(all.far, 0.05 * all.queries);
    }
}

/// Boxes look for their start on the way already. What they find is the end of two thirds of the walks. A
/// pair that comes to rest after that keeps its features.
TEST(NearerStart, OfBoxesShortensWalks) {
    const auto any = [](scene::Rng& rng, const Mat3d&) { return rng.rotation(); };
    const FarSteps far = ask_moving<box<f64>>(*scene::make_shape("cube8"), any);
    EXPECT_LT(far.steps, 0.4 * far.raw);
    EXPECT_GT(far.far, 0.6 * far.queries);
    EXPECT_EQ(far.again, far.queries);
    const FarSteps small = ask_moving<box<f64>>(*scene::make_shape("cube8"), turning_by(0.01));
    EXPECT_LT(small.far, 0.1 * small.queries);
}

/// On long bodies the line between the origins points to no nearer start.
TEST(NearerStart, IsGivenUpWhereThereIsNone) {
    const FarSteps all = ask_moving<aos<f64>>(*scene::make_shape("ellipsoid38"), turning_by(0.5));
    EXPECT_LT(all.far, 0.2 * all.queries);
}

/// A nearer vertex of a prism may be half its ring of edges away: the pair finds out once.
TEST(NearerStart, IsNotSoughtAgainWhereItShortensNoWalk) {
    std::vector<Vec3d> points;
    for (int i = 0; i < 400; ++i)
        for (const double z : {-0.5, 0.5})
            points.emplace_back(std::cos(i * std::numbers::pi / 200), std::sin(i * std::numbers::pi / 200),
                                z);
    const FarSteps all = ask_moving<aos<f64>>(*convex_hull(points), turning_by(0.5));
    EXPECT_GT(all.on, 0.9 * all.queries);
}

/// The bodies' nearer features stay, wherever they lie.
TEST(NearerStart, MovesNothingThatIsNearer) {
    using Table = aos<f64>;
    const Table table(*scene::make_shape("sphere38"), Parts::features);
    scene::Rng rng(22);
    int moved = 0, stayed = 0;
    for (int i = 0; i < 2000; ++i) {
        const Transform<double> into_a{rng.rotation(), rng.on_sphere() * rng.uniform(0, 4)};
        const Transform<double> into_b = into_a.inverse();
        const auto any = [&] {
            return Feature<Table>::of_vertex(static_cast<Index>(rng.below(table.vertex_count())));
        };
        vclip::Body<Table> a{table, into_a, any()}, b{table, into_b, any()};
        const auto between = [&] {
            return norm(
                Vec3d(table.vertex(a.feature.vertex()) - into_a.point(table.vertex(b.feature.vertex()))));
        };
        const double before = between();
        if (vclip::start_nearer(a, b) == vclip::Start::nearer) {
            ++moved;
            EXPECT_LT(between(), before);
        } else {
            ++stayed;
            EXPECT_EQ(between(), before);
        }
    }
    std::printf("moved %d, stayed %d\n", moved, stayed);
    EXPECT_GT(moved, 100);
    EXPECT_GT(stayed, 10);
}

}  // namespace
}  // namespace edgewise
