// SPDX-License-Identifier: MIT
//
// One table at many scales: GJK over a stretched view compared with the exact distance of the stretched
// points, and climbs with scans.
#include "edgewise/table/scaled_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise {
namespace {

const std::array<Vec3d, 6> scales = {Vec3d{1, 1, 1},        Vec3d{2, 0.5, 4},      Vec3d{1.7, 0.3, 0.9},
                                     Vec3d{-1.1, 2.3, 0.7}, Vec3d{30, 1.1, 0.013}, Vec3d{0.1, 0.1, 7}};

template <class Table>
Polyhedron stored(const char* shape) {
    return stored_body<Table>(scene::make_shape(shape).or_throw()).or_throw();
}

/// The body that a view of the table shows: each coordinate times its factor, rounded.
template <class Table>
std::vector<Vec3d> stretched(const Table& table, const Vec3d& scale) {
    using Compute = ComputeOf<Table>;
    std::vector<Vec3d> points;
    for (const auto v : table.all_vertices()) {
        const Vec3<Compute> point = table.vertex(v);
        Vec3d& product = points.emplace_back();
        for (int k = 0; k < 3; ++k) product[k] = point[k] * static_cast<Compute>(scale[k]);
    }
    return points;
}

double extent_of(const std::vector<Vec3d>& points) {
    double extent = 0;
    for (const Vec3d& point : points) extent = std::max(extent, 2 * max_abs(point));
    return extent;
}

/// Returns a random near pose: bodies of the given extent sometimes touch.
Pose near_pose(scene::Rng& rng, double extent) {
    Pose pose;
    pose.rotation = rng.rotation();
    for (int k = 0; k < 3; ++k) pose.translation[k] = rng.uniform(-extent, extent);
    return pose;
}

struct ScaleRegimes {
    int separated = 0, overlapping = 0, wrong = 0;
    double error = 0;  ///< over the size of the problem
};

template <class Table>
void ask(const Table& table, const Vec3d& scale_a, const Vec3d& scale_b, scene::Rng& rng,
         ScaleRegimes& seen) {
    using View = ScaledTable<Table>;
    const View a(table, scale_a), b(table, scale_b);
    const std::vector<Vec3d> points_a = stretched(table, scale_a), points_b = stretched(table, scale_b);
    const double extent = std::max(extent_of(points_a), extent_of(points_b));
    SimplexPair<View, View> warm(a, b);
    for (int i = 0; i < 12; ++i) {
        const Pose pose_a = near_pose(rng, extent / 2), pose_b = near_pose(rng, extent / 2);
        const auto exact = truth::exact_distance(points_a, pose_a, points_b, pose_b).or_throw();
        const double size = std::max(extent, norm(Vec3d(pose_a.translation - pose_b.translation)));
        const bool in_contact = exact.verdict != truth::ExactVerdict::separated;
        ++(in_contact ? seen.overlapping : seen.separated);
        SimplexPair<View, View> cold(a, b);
        for (auto* pair : {&cold, &warm}) {
            const Distance answer = Gjk::query(a, b, relative_pose(pose_a, pose_b), *pair);
            seen.wrong += (answer.status != Status::separated) != in_contact;
            seen.error = std::max(seen.error, std::abs(answer.distance - exact.distance) / size);
        }
    }
}

template <class Table>
void expect_exact(double allowed) {
    scene::Rng rng(5);
    ScaleRegimes seen;
    for (const char* shape : {"cube8", "sphere38", "sphere386"}) {
        const Table table(stored<Table>(shape), Parts::support);
        for (const Vec3d& scale_a : scales)
            for (const Vec3d& scale_b : scales) ask(table, scale_a, scale_b, rng, seen);
    }
    std::printf("%s: %d separated, %d in contact, worst error %.2g of the size\n",
                std::string(Table::name).c_str(), seen.separated, seen.overlapping, seen.error);
    EXPECT_EQ(seen.wrong, 0);
    EXPECT_LT(seen.error, allowed);
    EXPECT_GT(seen.separated, 100);
    EXPECT_GT(seen.overlapping, 100);
}

TEST(ScaledTable, AnswersAreThoseOfTheStretchedPoints) {
    expect_exact<lean<f64>>(verified_error_double);
    expect_exact<lean<f32>>(verified_error_single);
}

TEST(ScaledTable, ClimbsFindWhatScansFind) {
    using Table = lean<f64>;
    const Table table(stored<Table>("sphere386"), Parts::support);
    scene::Rng rng(7);
    double worst = 0;
    for (const Vec3d& scale : scales) {
        const ScaledTable<Table> view(table, scale);
        ASSERT_TRUE(view.climbable());
        for (int i = 0; i < 300; ++i) {
            const Vec3d direction = rng.on_sphere();
            const auto start = static_cast<Index>(rng.below(view.vertex_count()));
            const double climbed = climb_support(view, direction, start).along,
                         scanned = scan_support(view, direction).along;
            worst = std::max(worst, (scanned - climbed) / view.reach());
        }
    }
    std::printf("a climb ends %.2g of the reach below a scan\n", worst);
    EXPECT_LE(worst, Tolerance<double>::level);
}

static_assert(ClimbingTable<ScaledTable<lean<f32>>>);

/// A scale that is none, or takes the body out of range: no query computes with it.
TEST(ScaledTable, QueriesAtAScaleThatIsNoneFail) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                     infinity = std::numeric_limits<double>::infinity();
    const auto expect_failures = [&](const auto& table, double too_large) {
        using View = ScaledTable<std::remove_cvref_t<decltype(table)>>;
        const View good(table, Vec3d(1, 2, 3));
        for (const double bad : {nan, infinity, -infinity, 0.0, too_large, -too_large, 1 / too_large}) {
            for (int axis = 0; axis < 3; ++axis) {
                Vec3d scale(1, 1, 1);
                scale[axis] = bad;
                const View view(table, scale);
                SimplexPair<View, View> pair(view, good), other(good, view);
                const Transform<double> pose{Mat3d::Identity(), Vec3d(0.5, 0, 0)};
                EXPECT_EQ(Gjk::query(view, good, pose, pair).status, Status::failed) << scale.transpose();
                EXPECT_EQ(Gjk::query(good, view, pose, other).status, Status::failed) << scale.transpose();
            }
        }
    };
    expect_failures(lean<f64>(stored<lean<f64>>("cube8"), Parts::support), 1e150);
    expect_failures(lean<f32>(stored<lean<f32>>("cube8"), Parts::support), 1e30);
}

}  // namespace
}  // namespace edgewise
