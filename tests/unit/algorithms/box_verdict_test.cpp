// SPDX-License-Identifier: MIT
//
// Boxes against exact distances. The verdict by separating axes: at gaps and depths from 1e-14 of the size
// on, turned at random, hardly or not at all, and with edges that cross at angles as small as their gap,
// which only the direction across them separates. V-Clip from its start on boxes: how often that is the end.
#include "edgewise/algorithms/box_verdict.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/box.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/truth/accuracy_band.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise {
namespace {

using Box = box<f64>;
constexpr QueryOptions verdict{.cutoff = 0};

Polyhedron box_with(const Vec3d& half) {
    std::vector<Vec3d> corners;
    for (int corner = 0; corner < 8; ++corner)
        corners.push_back(
            half.cwiseProduct(Vec3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
    return Box::stored_body(convex_hull(corners).or_throw()).or_throw();
}

Vec3d half_extents(scene::Rng& rng) {
    return {rng.uniform(0.05, 1), rng.uniform(0.05, 1), rng.uniform(0.05, 1)};
}

double magnitude(scene::Rng& rng, double least, double most) {
    return std::pow(10.0, rng.uniform(least, most));
}

double distance(const Box& a, const Box& b, const Pose& pose) {
    SimplexPair<Box, Box> cold(a, b);
    return Gjk::query(a, b, {pose.rotation, pose.translation}, cold).distance;
}

/// B in any direction from A, at about this distance; below 0 deeper than contact by that much.
Pose at_gap(scene::Rng& rng, const Box& a, const Box& b, double gap) {
    Pose pose;
    const double angle = rng.uniform(0, 1) < 0.5 ? magnitude(rng, -17, -1) : rng.uniform(0, 3);
    pose.rotation = rotation_matrix(scene::rotation_about(rng.on_sphere(), angle));
    const Vec3d towards = rng.on_sphere();
    pose.translation = 5 * towards;
    for (int i = 0; i < 60; ++i)
        pose.translation -= 0.99 * (distance(a, b, pose) - std::max(gap, 0.0)) * towards;
    pose.translation += std::min(gap, 0.0) * towards;
    return pose;
}

/// Edges that cross, so near to parallel that the faces behind them overlap along their normals.
Pose crossing(scene::Rng& rng, const Vec3d& half_a, const Vec3d& half_b) {
    const double angle = magnitude(rng, -13, -2), gap = angle * magnitude(rng, -2, -0.5);
    Pose pose;
    pose.rotation = rotation_matrix(scene::rotation_about(Vec3d(1, 1, 0).normalized(), angle));
    const Vec3d at_edge = multiply(pose.rotation, Vec3d(-half_b.x(), -half_b.y(), 0));
    const Vec3d across = Vec3d(1, 1, 0).normalized();
    pose.translation = Vec3d(half_a.x(), half_a.y(), 0) + gap * across - at_edge;
    return pose;
}

struct Seen {
    int by_a = 0, by_b = 0, by_edges = 0, overlapping = 0, in_band = 0, wrong = 0;
};

void add(const Polyhedron& body_a, const Polyhedron& body_b, const Pose& pose, Seen& seen) {
    const Box a(body_a, Parts::support), b(body_b, Parts::support);
    const Transform<double> a_from_b{pose.rotation, pose.translation};
    SimplexPair<Box, Box> pair(a, b);
    const Distance answer = Gjk::query(a, b, a_from_b, pair, verdict);
    const auto exact = truth::exact_distance(body_a.vertices, Pose{}, body_b.vertices, pose).or_throw();
    const bool separated = answer.status == Status::separated;
    const truth::AccuracyBand band =
        truth::accuracy_band(body_a.vertices, Pose{}, body_b.vertices, pose, Tolerance<double>::eps);
    EXPECT_EQ(answer.steps, 1);
    if (separated != (exact.verdict == truth::ExactVerdict::separated)) {
        // A wrong "separated" is of bodies in contact: its gap along the axis is rounding.
        const bool excused = !separated && exact.distance <= band.band;
        seen.in_band += excused;
        seen.wrong += !excused && !(separated && exact.verdict == truth::ExactVerdict::touching);
        return;
    }
    if (!separated) {
        ++seen.overlapping;
        return;
    }
    EXPECT_GE(answer.distance, exact.distance) << "an upper bound";
    EXPECT_NEAR(norm(answer.normal), 1, 1e-15);
    EXPECT_GT(dot(answer.normal, pose.translation), 0);
    const Vec3d in_b = multiply_transposed(pose.rotation, answer.normal);
    if (max_abs(answer.normal) > 1 - 1e-15)
        ++seen.by_a;
    else if (max_abs(in_b) > 1 - 1e-15)
        ++seen.by_b;
    else
        ++seen.by_edges;
}

TEST(BoxVerdict, IsExactBeyondTheBand) {
    scene::Rng rng(7);
    Seen near, crossed;
    for (int i = 0; i < 6000; ++i) {
        const Vec3d half_a = half_extents(rng), half_b = half_extents(rng);
        const Polyhedron body_a = box_with(half_a), body_b = box_with(half_b);
        const double gap = magnitude(rng, -14, -1) * (i % 3 == 0 ? -1 : 1);
        add(body_a, body_b, at_gap(rng, Box(body_a, Parts::support), Box(body_b, Parts::support), gap), near);
        add(body_a, body_b, crossing(rng, half_a, half_b), crossed);
    }
    for (const Seen& seen : {near, crossed})
        std::printf(
            "boxes: by faces of A %d, of B %d, by edges %d; overlapping %d; in the band %d, wrong %d\n",
            seen.by_a, seen.by_b, seen.by_edges, seen.overlapping, seen.in_band, seen.wrong);
    EXPECT_EQ(near.wrong + crossed.wrong, 0);
    EXPECT_GT(std::min({near.by_a, near.by_b, near.by_edges}), 300);
    EXPECT_GT(near.overlapping, 1500);
    EXPECT_GT(crossed.by_edges, 3000);
}

/// Between its gap along every axis and its tolerance the distance decides: GJK is asked.
TEST(BoxVerdict, LeavesToleratedGapsToTheDistance) {
    scene::Rng rng(8);
    int asked = 0, beyond = 0, touching = 0;
    for (int i = 0; i < 2000; ++i) {
        const Polyhedron body_a = box_with(half_extents(rng)), body_b = box_with(half_extents(rng));
        const Box a(body_a, Parts::support), b(body_b, Parts::support);
        const double tolerance = 0.1;
        const Pose pose = at_gap(rng, a, b, rng.uniform(-0.1, 0.3));
        SimplexPair<Box, Box> pair(a, b);
        Distance known;
        asked += !answer_boxes(a, b, {pose.rotation, pose.translation}, tolerance, known);
        const Distance answer = Gjk::query(a, b, {pose.rotation, pose.translation}, pair,
                                           {.contact_tolerance = tolerance, .cutoff = 0});
        const double exact = truth::exact_distance(body_a.vertices, Pose{}, body_b.vertices, pose)->distance;
        ASSERT_GT(std::abs(exact - tolerance), 1e-9);
        EXPECT_EQ(answer.status == Status::separated, exact > tolerance);
        beyond += exact > tolerance;
        touching += exact > 0 && exact < tolerance;
    }
    std::printf("boxes: %d beyond the tolerance, %d within it, %d left to GJK\n", beyond, touching, asked);
    EXPECT_GE(asked, touching);
    EXPECT_GT(touching, 300);
    EXPECT_GT(beyond, 300);
}

struct Starts {
    int separated = 0, at_once = 0, overlapping = 0, by_a_point = 0, wrong = 0;
    int steps_again = 0;  ///< of the same queries, asked a second time
    double worst = 0;     ///< error over the larger of offset and size
};

void add_cold(const Polyhedron& body_a, const Polyhedron& body_b, const Pose& pose, Starts& starts) {
    const Box a(body_a, Parts::features), b(body_b, Parts::features);
    FeaturePair<Box, Box> pair(a, b);
    const Distance answer = VClip::query(a, b, {pose.rotation, pose.translation}, pair);
    const auto exact = truth::exact_distance(body_a.vertices, Pose{}, body_b.vertices, pose).or_throw();
    if ((answer.status == Status::separated) != (exact.verdict == truth::ExactVerdict::separated)) {
        ++starts.wrong;
    } else if (answer.status == Status::separated) {
        ++starts.separated;
        starts.at_once += answer.steps == 1;
        const double size = std::max({1.0, norm(pose.translation)});
        starts.worst = std::max(starts.worst, std::abs(answer.distance - exact.distance) / size);
    } else {
        ++starts.overlapping;
        starts.by_a_point += answer.steps == 1;
    }
    starts.steps_again += VClip::query(a, b, {pose.rotation, pose.translation}, pair).steps;
}

template <class NextRotation, class NextOffset>
Starts ask_cold(const NextRotation& rotation, const NextOffset& offset) {
    scene::Rng rng(9);
    Starts starts;
    for (int i = 0; i < 6000; ++i) {
        const Polyhedron body_a = box_with(half_extents(rng)), body_b = box_with(half_extents(rng));
        add_cold(body_a, body_b, {rotation(rng), offset(rng)}, starts);
    }
    std::printf(
        "boxes: %d separated, %d at once; %d overlapping, %d by a point of both; %d wrong, worst %.3g\n",
        starts.separated, starts.at_once, starts.overlapping, starts.by_a_point, starts.wrong, starts.worst);
    EXPECT_EQ(starts.wrong, 0);
    EXPECT_LT(starts.worst, 1e-15);
    EXPECT_EQ(starts.steps_again, starts.separated + starts.overlapping);
    return starts;
}

TEST(BoxStart, IsTheEndOfMostQueries) {
    const Starts starts =
        ask_cold([](scene::Rng& rng) { return rng.rotation(); },
                 [](scene::Rng& rng) -> Vec3d { return rng.on_sphere() * rng.uniform(0, 3); });
    EXPECT_GT(starts.at_once, 0.7 * starts.separated);
    EXPECT_GT(starts.by_a_point, 0.3 * starts.overlapping);
}

/// A walk may end at the first vertices of both boxes, where a cold one starts.
TEST(BoxStart, LeavesNoEnd) {
    const Starts starts = ask_cold(
        [](scene::Rng& rng) -> Mat3d {
            return Eigen::AngleAxis(rng.uniform(0, 0.5), rng.on_sphere()).toRotationMatrix() *
                   Vec3d(-1, -1, 1).asDiagonal();
        },
        [](scene::Rng& rng) -> Vec3d { return -Vec3d(1, 1, 1) - rng.on_sphere(); });
    EXPECT_GT(starts.separated, 2000);
}

}  // namespace
}  // namespace edgewise
