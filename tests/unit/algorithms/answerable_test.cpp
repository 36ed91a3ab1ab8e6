// SPDX-License-Identifier: MIT
//
// Invalid poses: every query at one fails, in either precision, and says nothing of contact; the pair stays
// as it was. Poses at the bounds are answered.
#include "edgewise/algorithms/answerable.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/near_pair.hpp"
#include "edgewise/algorithms/penetration.hpp"
#include "edgewise/algorithms/query_batch.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/points_soa.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

/// Poses with one entry that is NaN, infinite or far too large; and with matrices that are no rotation:
/// scaled, sheared, mirrored.
std::vector<Transform<double>> bad_poses(double too_far) {
    std::vector<Transform<double>> poses;
    const Transform<double> good{Mat3d::Identity(), Vec3d(3, 0, 0)};
    for (const double value : {nan, infinity, -infinity, 1e200, 1e308}) {
        for (int i = 0; i < 12; ++i) {
            poses.push_back(good);
            (i < 9 ? poses.back().rotation(i / 3, i % 3) : poses.back().translation[i - 9]) = value;
        }
    }
    poses.push_back({Mat3d::Identity(), Vec3d(too_far, 0, 0)});
    poses.push_back({Mat3d::Identity(), Vec3d(0, -too_far, 0)});
    poses.push_back({Mat3d::Zero(), Vec3d(3, 0, 0)});
    poses.push_back({1.05 * Mat3d::Identity(), Vec3d(3, 0, 0)});
    Mat3d sheared = Mat3d::Identity();
    sheared(0, 1) = 0.1;
    poses.push_back({sheared, Vec3d(3, 0, 0)});
    scene::Rng rng(4);
    for (int axis = 0; axis < 3; ++axis) {
        Mat3d mirror = Mat3d::Identity();
        mirror(axis, axis) = -1;
        poses.push_back({mirror, Vec3d(3, 0, 0)});
        poses.push_back({multiply(rng.rotation(), mirror), Vec3d(3, 0, 0)});
    }
    poses.push_back({-Mat3d::Identity(), Vec3d(3, 0, 0)});
    return poses;
}

template <class Algorithm, class Table>
void expect_failures(double too_far) {
    const Table table(*scene::make_shape("sphere18"), Parts::features);
    using TablePair = typename Algorithm::template Pair<Table, Table>;
    TablePair pair(table, table);
    const Transform<double> good{Mat3d::Identity(), Vec3d(3, 0.5, 0)};
    const Distance answer = Algorithm::query(table, table, good, pair);
    ASSERT_EQ(answer.status, Status::separated);
    for (const Transform<double>& pose : bad_poses(too_far)) {
        const TablePair before = pair;
        TablePair not_asked = pair;
        const Distance expected = Algorithm::query(table, table, good, not_asked);
        const Distance failed = Algorithm::query(table, table, pose, pair);
        EXPECT_EQ(failed.status, Status::failed) << pose.rotation << "\n" << pose.translation;
        EXPECT_EQ(failed.distance, 0);
        EXPECT_TRUE(pair == before);
        TablePair cold(table, table);
        EXPECT_EQ(Algorithm::query(table, table, pose, cold).status, Status::failed);
        const PairQuery<Table, Table, Algorithm> asked[] = {{&table, &table, pose, &cold},
                                                            {&table, &table, good, &pair}};
        Distance answers[2];
        query_batch<Table, Table, Algorithm>(asked, answers);
        EXPECT_EQ(answers[0].status, Status::failed);
        EXPECT_EQ(answers[1].status, Status::separated);
        EXPECT_EQ(answers[1].distance, expected.distance)
            << "the next query is answered as if nothing had been";
        NearPair<Algorithm, Table, Table> near(table, table);
        EXPECT_FALSE(near.nearer_than(0.5, good));
        EXPECT_TRUE(near.nearer_than(0.5, pose)) << "to be looked at";
        EXPECT_EQ(near.bounds(pose).least, 0);
        EXPECT_FALSE(near.nearer_than(0.5, good)) << "as before";
        PenetrationSpace space;
        const Penetration depth =
            penetration(table, table, pose, SimplexPair<Table, Table>(table, table), space);
        EXPECT_FALSE(depth.converged);
        EXPECT_EQ(depth.depth, 0);
        EXPECT_EQ(max_abs(depth.normal), 0);
    }
}

TEST(Answerable, PosesThatAreNoneFail) {
    expect_failures<VClip, aos<f64>>(1e155);
    expect_failures<VClip, aos<f32>>(1e19);
    expect_failures<VClip, aos<mixed>>(1e155);
    expect_failures<Gjk, aos<f64>>(1e155);
    expect_failures<Gjk, points_soa<f64>>(1e155);
    expect_failures<Gjk, points_soa<f32>>(1e19);
}

/// At the largest allowed distance, answers are right to a rounding step.
template <class Algorithm, class Table>
void expect_right_at(double distance) {
    const Table table(*scene::make_shape("cube8"), Parts::features);
    typename Algorithm::template Pair<Table, Table> pair(table, table);
    scene::Rng rng(1);
    for (int i = 0; i < 50; ++i) {
        const Vec3d along = rng.on_sphere();
        const Distance answer = Algorithm::query(table, table, {rng.rotation(), distance * along}, pair);
        EXPECT_EQ(answer.status, Status::separated);
        EXPECT_NEAR(answer.distance / distance, 1, 1e-6);
    }
}

TEST(Answerable, TheFarthestPosesAreAnswered) {
    constexpr double farthest = 0.5 * Tolerance<double>::largest_offset;
    constexpr double farthest_single = 0.5 * double{Tolerance<float>::largest_offset};
    expect_right_at<VClip, aos<f64>>(farthest);
    expect_right_at<VClip, aos<f32>>(farthest_single);
    expect_right_at<Gjk, aos<f64>>(farthest);
    expect_right_at<Gjk, points_soa<f64>>(farthest);
    expect_right_at<Gjk, points_soa<f32>>(farthest_single);
}

/// Rotations that were typed in with three digits, or turned in single precision for long, are rotations.
TEST(Answerable, SloppyRotationsAreTaken) {
    scene::Rng rng(2);
    for (int i = 0; i < 1000; ++i) {
        Mat3d rotation = rng.rotation();
        EXPECT_TRUE(is_answerable<double>({rotation, Vec3d::Zero()}));
        for (double& entry : rotation.reshaped()) entry = std::round(entry * 1000) / 1000;
        EXPECT_TRUE(is_answerable<float>({rotation, Vec3d::Zero()}));
    }
}

/// Rotations in single, and sloppier ones: V-Clip answers as GJK does, to what the matrix is off by.
TEST(Answerable, VClipAndGjkAgreeOnSloppyRotations) {
    using Table = aos<f64>;
    const Table table(*scene::make_shape("cube8"), Parts::features);
    scene::Rng rng(5);
    int handed_on = 0, differ = 0;
    for (int i = 0; i < 20'000; ++i) {
        Transform<double> pose{rng.rotation(), rng.in_cube(1.2)};
        const double off = std::ldexp(1.0, -static_cast<int>(rng.below(40)) - 7);
        for (double& entry : pose.rotation.reshaped()) entry += off * rng.uniform(-1, 1);
        FeaturePair<Table, Table> features(table, table);
        SimplexPair<Table, Table> simplex(table, table);
        const Distance clipped = VClip::query(table, table, pose, features);
        const Distance expected = Gjk::query(table, table, pose, simplex);
        handed_on += clipped.fallbacks;
        const double error = 8 * off + 1e-14;
        const bool separated = clipped.status == Status::separated;
        differ += separated != (expected.status == Status::separated);
        EXPECT_NEAR(clipped.distance, expected.distance, error) << off;
        if (separated != (expected.status == Status::separated)) {
            EXPECT_LE(std::max(clipped.distance, expected.distance), error) << off;
        }
    }
    std::printf("%d of 20000 handed on, %d verdicts differ within the error\n", handed_on, differ);
    EXPECT_GT(handed_on, 1000);
}

/// Bounds stay right when poses and their mirror images, which are not answered, take turns.
TEST(Answerable, BoundsHoldBesideMirroredPoses) {
    using Table = aos<f64>;
    const Table table(*scene::make_shape("tetra4"), Parts::features);
    NearPair<Gjk, Table, Table> pair(table, table);
    scene::Rng rng(6);
    std::uint64_t known = 0;
    for (int i = 0; i < 4000; ++i) {
        Transform<double> pose{rng.rotation(), rng.on_sphere() * rng.uniform(1, 4)};
        if (i % 4 == 3) pose.rotation = pose.rotation.cast<float>().cast<double>();
        const std::uint64_t before = pair.queries();
        for (int step = 0; step < 3; ++step) {
            SimplexPair<Table, Table> cold(table, table);
            const double distance = Gjk::query(table, table, pose, cold).distance;
            const DistanceInterval bounds = pair.bounds(pose);
            EXPECT_LE(bounds.least, distance + 1e-12);
            EXPECT_GE(bounds.most, distance - 1e-12);
            EXPECT_EQ(pair.nearer_than(0.7, pose), distance < 0.7);
            Transform<double> mirrored = pose;
            mirrored.rotation.col(step) *= -1;
            EXPECT_TRUE(pair.nearer_than(0.7, mirrored));
            pose.translation += rng.in_cube(0.02);
        }
        known += 6 - (pair.queries() - before);
    }
    std::printf("bounds told %llu times\n", static_cast<unsigned long long>(known));
    EXPECT_GT(known, 1000U);
}

}  // namespace
}  // namespace edgewise
