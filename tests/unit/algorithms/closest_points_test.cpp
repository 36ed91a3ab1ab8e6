// SPDX-License-Identifier: MIT
//
// Closest points of segments and points compared with exact arithmetic: crossing and skew segments, sharing
// ends, parallel to every degree. The distance must be right; the places are free where segments are
// parallel.
#include "edgewise/algorithms/vclip/closest_points.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

using vclip::Segment;

double exact(const Segment<double>& a, const Segment<double>& b) {
    const std::array<Vec3d, 2> ends_a = {a.tail, a.head}, ends_b = {b.tail, b.head};
    const auto answer = truth::exact_distance(ends_a, {}, ends_b, {});
    EXPECT_TRUE(answer) << answer.error;
    return answer ? answer->distance : 0;
}

/// Distance of a point from a segment: how far from it a point that should be on it is.
double off(const Segment<double>& segment, const Vec3d& point) { return exact(segment, {point, point}); }

template <class Scalar>
Segment<Scalar> as(const Segment<double>& s) {
    return {s.tail.cast<Scalar>(), s.head.cast<Scalar>()};
}

struct Errors {
    double distance = 0, place = 0;
};

template <class Scalar>
void ask(Segment<double> a, Segment<double> b, Errors& worst) {
    if (sizeof(Scalar) == sizeof(float)) {
        for (Vec3d* end : {&a.tail, &a.head, &b.tail, &b.head}) *end = to_single(*end);
    }
    const auto [on_a, on_b] = vclip::closest_on_segments(as<Scalar>(a), as<Scalar>(b));
    const Vec3d point_a = on_a.template cast<double>(), point_b = on_b.template cast<double>();
    const double found = norm(Vec3d(point_a - point_b));
    worst.distance = std::max(worst.distance, std::abs(found - exact(a, b)));
    worst.place = std::max({worst.place, off(a, point_a), off(b, point_b)});
}

/// Two segments of length about 1, at an angle; their lines pass each other at a gap.
std::pair<Segment<double>, Segment<double>> pair_at(scene::Rng& rng, double angle, double gap) {
    const Vec3d u = rng.on_sphere();
    const Vec3d side = cross(u, rng.on_sphere());
    const Vec3d across = side / norm(side);
    const Vec3d normal = cross(u, across);
    const Vec3d v = u + angle * across;
    const double s = rng.uniform(-1.5, 0.5), t = rng.uniform(-1.5, 0.5);
    return {{s * u, (s + 1) * u}, {t * v + gap * normal, (t + 1) * v + gap * normal}};
}

TEST(ClosestOnSegments, NearlyParallelToEveryDegree) {
    scene::Rng rng(1);
    for (int power = 0; power <= 17; ++power) {
        Errors f64, f32;
        for (int i = 0; i < 2000; ++i) {
            const double angle = std::pow(10.0, -power) * rng.uniform(-1, 1);
            const auto [a, b] = pair_at(rng, power == 17 ? 0 : angle, rng.below(3) == 0 ? 0 : rng.uniform());
            ask<double>(a, b, f64);
            ask<float>(a, b, f32);
        }
        std::printf("segments at 1e-%02d rad: worst error %.3g double, %.3g single\n", power, f64.distance,
                    f32.distance);
        EXPECT_LE(f64.distance, 1e-14);
        EXPECT_LE(f64.place, 1e-15);
        EXPECT_LE(f32.distance, 1e-5);
        EXPECT_LE(f32.place, 1e-6);
    }
}

TEST(ClosestOnSegments, LatticeSegmentsMeetTouchAndOverlap) {
    scene::Rng rng(2);
    Errors worst;
    int meeting = 0, points = 0;
    for (int i = 0; i < 20000; ++i) {
        std::array<Vec3d, 4> p;
        for (Vec3d& corner : p) corner = rng.in_cube(2).array().round();
        if (p[0] == p[1] || p[2] == p[3]) continue;  // an edge has a length
        const Segment<double> a{p[0], p[1]}, b{p[2], p[3]};
        ask<double>(a, b, worst);
        meeting += exact(a, b) == 0;
        points += p[0] == p[2] || p[0] == p[3] || p[1] == p[2] || p[1] == p[3];
    }
    std::printf("segments on a lattice: worst error %.3g; %d meet\n", worst.distance, meeting);
    EXPECT_LE(worst.distance, 1e-14);
    EXPECT_GT(meeting, 100);
    EXPECT_GT(points, 100);
}

TEST(ClosestOnSegment, PointBeyondTheEndsAndBetween) {
    scene::Rng rng(3);
    double worst = 0;
    int tails = 0, heads = 0, between = 0;
    for (int i = 0; i < 5000; ++i) {
        const Segment<double> segment{rng.in_cube(1), rng.in_cube(1)};
        const Vec3d point = rng.in_cube(3);
        const Vec3d foot = vclip::closest_on_segment(segment, point);
        worst = std::max(worst, std::abs(norm(Vec3d(point - foot)) - off(segment, point)));
        tails += foot == segment.tail;
        heads += norm(Vec3d(foot - segment.head)) < 1e-15;
        between += foot != segment.tail && norm(Vec3d(foot - segment.head)) > 1e-3;
    }
    std::printf("point and segment: worst error %.3g\n", worst);
    EXPECT_LE(worst, 1e-14);
    EXPECT_GT(std::min({tails, heads, between}), 500);
}

TEST(FootOnFace, LiesInThePlaneAndStraightBelowThePoint) {
    const auto body = scene::make_shape("sphere38");
    ASSERT_TRUE(body) << body.error;
    const ReferenceTable table(*body);
    scene::Rng rng(4);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        const auto f = static_cast<Index>(rng.below(body->face_count()));
        const Vec3d point = rng.in_cube(3);
        const Vec3d foot = vclip::foot_on_face(table, f, point).point;
        const Plane<double>& plane = body->face_planes[f];
        worst =
            std::max({worst, std::abs(plane.distance(foot)), norm(cross(plane.normal, Vec3d(point - foot)))});
    }
    std::printf("foot on a face: worst error %.3g\n", worst);
    EXPECT_LE(worst, 1e-14);
}

}  // namespace
}  // namespace edgewise
