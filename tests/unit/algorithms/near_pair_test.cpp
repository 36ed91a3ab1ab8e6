// SPDX-License-Identifier: MIT
//
// Bounds carried over motions, compared with the distance by brute force: never wrong, and rarely undecided.
#include "edgewise/algorithms/near_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "brute_force.hpp"
#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

/// How far outside its bounds a distance was, and how often bounds decided.
struct Seen {
    double outside = 0;
    int asked = 0, told_near = 0, told_far = 0, wrong = 0;
};

/// Rotation about an axis by an angle, to rounding.
Mat3d turn(const Vec3d& axis, double angle) {
    Mat3d cross_matrix;
    cross_matrix << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    return Mat3d::Identity() + std::sin(angle) * cross_matrix +
           (1 - std::cos(angle)) * Mat3d(cross_matrix * cross_matrix);
}

/// B turns about itself and sways to and from A, by steps of this size.
template <class Algorithm, class Table>
void sway(const Polyhedron& body, double step, double margin, scene::Rng& rng, Seen& seen) {
    const Table table(body, Algorithm::parts);
    NearPair<Algorithm, Table, Table> pair(table, table);
    Pose pose_b{rng.rotation(), {}};
    const Vec3d axis = rng.on_sphere(), away = rng.on_sphere();
    for (int i = 0; i < 150; ++i) {
        pose_b.rotation = turn(axis, step) * pose_b.rotation;
        pose_b.translation = away * (2.2 + 0.8 * std::sin(5 * step * i)) + rng.in_ball() * step * 0.1;
        const Transform<double> a_from_b{pose_b.rotation, pose_b.translation};
        const double truth = truth::brute_force_distance(body, {}, body, pose_b);
        const DistanceInterval bounds = pair.bounds(a_from_b);
        seen.outside = std::max({seen.outside, bounds.least - truth, truth - bounds.most});
        const std::uint64_t before = pair.queries();
        const bool near = pair.nearer_than(margin, a_from_b);
        const double doubt = 4 * double{Tolerance<ComputeOf<Table>>::level};
        if (std::abs(truth - margin) > doubt) seen.wrong += near != (truth < margin);
        if (pair.queries() > before)
            ++seen.asked;
        else
            ++(near ? seen.told_near : seen.told_far);
    }
}

template <class Algorithm, class Table>
void expect_true_bounds(const char* name) {
    scene::Rng rng(7);
    for (const double step : {0.001, 0.01, 0.1, 1.0}) {
        Seen seen;
        for (const char* shape : {"tetra4", "cube8", "sphere38"}) {
            const Polyhedron body = stored_body<Table>(scene::make_shape(shape).or_throw()).or_throw();
            for (int i = 0; i < 4; ++i) sway<Algorithm, Table>(body, step, rng.uniform(0.1, 1), rng, seen);
        }
        std::printf("%s, steps of %g: %d asked, bounds gave %d near, %d far; outside by %.2g at most\n", name,
                    step, seen.asked, seen.told_near, seen.told_far, seen.outside);
        EXPECT_LE(seen.outside, 1e-14) << step;
        EXPECT_EQ(seen.wrong, 0) << step;
        if (step > 0.01) continue;
        EXPECT_LT(seen.asked, (seen.told_near + seen.told_far) / 5) << step;
        EXPECT_GT(seen.told_far, 100) << step;
    }
}

TEST(NearPair, BoundsHoldWhateverTheMotion) {
    expect_true_bounds<VClip, lean<f64>>("vclip lean_f64");
    expect_true_bounds<Gjk, lean<f64>>("gjk lean_f64");
    expect_true_bounds<Gjk, lean<f32>>("gjk lean_f32");
}

TEST(NearPair, KnowsNothingBeforeItAsks) {
    const DistanceBounds nothing;
    const Transform<double> here{Mat3d::Identity(), Vec3d::Zero()};
    EXPECT_FALSE(nothing.nearer_than(1, here).has_value());
    EXPECT_EQ(nothing.nearer_than(0, here), false) << "no distance is less than 0";
    EXPECT_EQ(nothing.at(here).least, 0);
}

/// Near: the distance by brute force. Beyond: no answer, mostly without a query, and a lower bound that
/// holds.
template <class Algorithm>
void expect_answers_within(double step, double margin) {
    scene::Rng rng(13);
    const Polyhedron body = scene::make_shape("sphere38").or_throw();
    const lean<f64> table(body, Algorithm::parts);
    NearPair<Algorithm, lean<f64>, lean<f64>> pair(table, table);
    int near = 0, beyond = 0, untold = 0;
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
        const Pose pose_b{turn(Vec3d::UnitZ(), step * i), Vec3d(2.3 + std::sin(step * i), 0.1, 0.05)};
        const Transform<double> a_from_b{pose_b.rotation, pose_b.translation};
        const double truth = truth::brute_force_distance(body, {}, body, pose_b);
        const std::uint64_t before = pair.queries();
        const auto answer = pair.answer_within(margin, a_from_b);
        if (std::abs(truth - margin) > 1e-12) {
            EXPECT_EQ(answer.has_value(), truth < margin) << i;
        }
        worst =
            std::max(worst, answer ? std::abs(answer->distance - truth) : pair.at_least(a_from_b) - truth);
        if (!answer) {
            EXPECT_GE(pair.at_least(a_from_b), margin * (1 - 1e-12)) << i;
        }
        ++(answer ? near : beyond);
        untold += !answer && pair.queries() > before;
    }
    std::printf("%s, %g rad a step: %d nearer than %g, %d beyond, %d of them by a query; off by %.2g\n",
                std::string(Algorithm::name).c_str(), step, near, margin, beyond, untold, worst);
    EXPECT_LE(worst, 1e-14);
    EXPECT_GT(std::min(near, beyond), 50);
    EXPECT_LT(untold, beyond / 3);
}

TEST(NearPair, AnswersWithinADistanceAndProvesTheRestFarther) {
    expect_answers_within<VClip>(0.01, 0.4);
    expect_answers_within<Gjk>(0.02, 0.3);
}

/// Distances around the ends of the carried bounds, by parts of the motion: nearer_than decides where these
/// do, to rounding.
TEST(NearPair, TellsWhereItsCarriedBoundsDo) {
    scene::Rng rng(11);
    int told_near = 0, told_far = 0, not_told = 0;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
        const Pose before{rng.rotation(), rng.in_ball()};
        const double step = std::pow(10.0, rng.uniform(-6, 0));
        const Transform<double> from{before.rotation, before.translation};
        const Transform<double> to{turn(rng.on_sphere(), step * rng.uniform(0, 1)) * before.rotation,
                                   before.translation + rng.in_ball() * step};
        const double least = rng.uniform(0.1, 2), most = least + rng.uniform(0, 1e-3);
        const DistanceBounds bounds({least, most}, from, rng.uniform(0, 1));
        const DistanceInterval now = bounds.at(to);
        const bool above = i % 2 == 0;
        const double end = above ? now.least : now.most;
        const double distance = end + (now.most - most) * rng.uniform(-1, 1);
        const auto told = bounds.nearer_than(distance, to);
        const bool should_tell = distance <= now.least || distance > now.most;
        if (told.has_value() != should_tell) worst = std::max(worst, std::abs(distance - end));
        EXPECT_EQ(told.value_or(distance > most), distance > most) << i;
        ++(!told ? not_told : *told ? told_near : told_far);
    }
    std::printf("bounds gave %d near, %d far, %d undecided; off by %.2g at most\n", told_near, told_far,
                not_told, worst);
    EXPECT_LE(worst, 1e-14);
    EXPECT_GT(std::min({told_near, told_far, not_told}), 4000);
}

}  // namespace
}  // namespace edgewise
