// SPDX-License-Identifier: MIT
//
// The scene `gap`: the gaps that were asked for, measured by exact arithmetic, in every regime.
//
// Two checks apply to a pair in contact. First, if B moves back along the line of approach by the requested
// depth t, the bodies are separated by less than the bound: t is the depth along that line. Second, the exact
// depth, the shortest way out, is between t w / s and t: the signed distance along the line is convex, 0 at
// the place s of contact, and -w or less where the centres meet; w is twice the inner radius about them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/exact_proof.hpp"
#include "made_scene.hpp"

namespace edgewise::scene {
namespace {

/// In body sizes: the placement's own, and a rounding of poses.
constexpr double bound = gap_placement_tolerance * (1 + 1e-6);

/// One pair, everything in body sizes.
struct PlacedPair {
    const Polyhedron& body;
    Pose a, b;

    [[nodiscard]] double size() const { return extent(body.vertices); }
    [[nodiscard]] Vec3d way() const {
        const Vec3d centre = vertex_mean(body.vertices);
        return b.apply(centre) - a.apply(centre);
    }
    /// Returns the distance after B moves back by `back` along the line of approach.
    [[nodiscard]] double distance(double back = 0) const {
        Pose pose = b;
        pose.translation += way() * (back * size() / norm(way()));
        return truth::exact_distance(body.vertices, a, body.vertices, pose).or_throw().distance / size();
    }
    [[nodiscard]] double depth() const {
        return truth::exact_depth(body.vertices, a, body.vertices, b).or_throw().depth / size();
    }
};

double inner_radius(const Polyhedron& body) {
    const Vec3d centre = vertex_mean(body.vertices);
    double least = reach(body.vertices, centre);
    for (const Plane<double>& plane : body.face_planes)
        least = std::min(least, -(dot(plane.normal, centre) + plane.offset));
    return least;
}

void expect_depth(const PlacedPair& pair, double asked) {
    const double at_contact = norm(pair.way()) / pair.size() + asked;
    const double slope = 2 * inner_radius(pair.body) / pair.size() / at_contact;  // or more, on the line
    EXPECT_GT(pair.distance(asked + bound), 0) << "moved back by the requested depth, B is separated";
    EXPECT_LT(pair.distance(asked), 2 * bound) << "by less than the bound";
    EXPECT_EQ(pair.distance(asked - 2 * bound / slope), 0) << "moved back by less, B still touches";
    EXPECT_LE(pair.depth(), asked + bound);
    EXPECT_GE(pair.depth(), (asked - 2 * bound / slope) * slope);
}

/// Whatever the gaps, the pairs have them: of one gap for all, what was asked is known of each.
TEST(Gap, IsTheOneAskedFor) {
    for (const char* name : {"tetra4", "cube8", "sphere38"}) {
        const Polyhedron body = *make_shape(name);
        for (const double asked : {-0.1, -0.01, -0.0001, 0.0, 0.001, 0.1, 1.0}) {
            double worst = 0, shallowest = 1;
            for (const Query& query : made_scene("gap", body, 12, {{"gap", asked}, {"span", 0}}, 5).queries) {
                const PlacedPair pair{body, query.pose_a, query.pose_b};
                if (asked < 0) {
                    expect_depth(pair, -asked);
                    shallowest = std::min(shallowest, pair.depth() / -asked);
                }
                worst = std::max(worst, std::abs(pair.distance() - std::max(asked, 0.0)));
            }
            std::printf(
                "%-8s gap %7.4f: worst error of the distance %.1e sizes; shortest way out at least "
                "%.2f of the way in\n",
                name, asked, worst, asked < 0 ? shallowest : 1);
            EXPECT_LE(worst, asked == 0 ? 2 * bound : bound) << "to touch is sought a tolerance off";
        }
    }
}

/// One of n gaps lies in each n-th of the range: sorted, none is farther than 1/n from its even place.
TEST(Gap, AreSpreadEvenlyOverEveryRegime) {
    const Polyhedron body = *make_shape("cube8");
    constexpr std::size_t count = 1100;
    const Workload w = made_scene("gap", body, count, {}, 5);
    std::array<std::size_t, 3> visited{};  // penetrating, near contact (0.01 sizes), beyond
    std::vector<double> distances;
    for (const Query& query : w.queries) {
        const PlacedPair pair{body, query.pose_a, query.pose_b};
        const double distance = pair.distance();
        distances.push_back(distance);
        ++visited[distance == 0 ? 0 : distance < 0.01 ? 1 : 2];
    }
    EXPECT_FALSE(std::is_sorted(distances.begin(), distances.end())) << "in random order";
    std::sort(distances.begin(), distances.end());
    double worst = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double place = -0.1 + 1.1 * static_cast<double>(i) / count;
        const double after = std::max(distances[i] - std::max(place, 0.0), 0.0);
        const double before = std::max(std::max(place, 0.0) - distances[i], 0.0);
        worst = std::max({worst, after, before});
    }
    std::printf(
        "of %zu pairs %zu penetrate, %zu are near contact, %zu beyond; worst step from even %.5f sizes\n",
        count, visited[0], visited[1], visited[2], worst);
    EXPECT_NEAR(double(visited[0]), 100, 1);
    EXPECT_NEAR(double(visited[1]), 10, 1);
    EXPECT_NEAR(double(visited[2]), 990, 2);
    EXPECT_LE(worst, 1.1 / count + bound);
    EXPECT_GT(distances.back(), 0.998);
}

/// A plate pushed in farther than it is thick comes out at its other side.
TEST(Gap, ThatThinBodiesCannotHaveIsRefused) {
    Polyhedron plate = *make_shape("cube8");
    for (Vec3d& v : plate.vertices) v.z() *= 0.01;
    for (Plane<double>& plane : plate.face_planes)
        if (std::abs(plane.normal.z()) > 0.5) plane.offset *= 0.01;
    const auto made =
        make_scene("gap", plate, {{"gap", -0.5}, {"span", 0}}, 1, 200, truth::brute_force_distance);
    ASSERT_FALSE(made);
    EXPECT_NE(made.error.find("raise gap"), std::string::npos) << made.error;
    EXPECT_EQ(made_scene("gap", plate, 20, {{"gap", 0.001}}, 5).queries.size(), 20U);
}

constexpr std::size_t pairs = 12, step_count = 60;

Workload proximity(SceneParameters given = {}) {
    given["pairs"] = double(pairs);
    return made_scene("proximity", *make_shape("sphere38"), pairs * step_count, given);
}

TEST(Proximity, StartsTheGapApart) {
    const Workload w = proximity();
    EXPECT_EQ(w.pair_count, pairs);
    EXPECT_EQ(w.instances.size(), 2 * pairs);
    EXPECT_EQ(w.frames.size(), step_count);
    const double size = extent(w.bodies[0].vertices);
    for (std::size_t i = 0; i < pairs; ++i)
        EXPECT_NEAR(distance_of(w, w.queries[i]), 0.001 * size, placement_tolerance * size) << "pair " << i;
}

/// The middles stay; a step turns by 0.25 / 60 rad, so that the pairs stay near, and some come to touch.
TEST(Proximity, StaysClose) {
    const Workload w = proximity();
    std::size_t touching = 0;
    double most = 0;
    for (std::size_t i = pairs; i < w.queries.size(); ++i) {
        const Query &now = w.queries[i], &before = w.queries[i - pairs];
        ASSERT_EQ(now.pair, before.pair);
        const Mat3d turn = now.pose_a.rotation * before.pose_a.rotation.transpose();
        EXPECT_NEAR(turn.trace(), 1 + 2 * std::cos(0.25 / 60), 1e-9);
        const double d = distance_of(w, now);
        touching += d == 0;
        most = std::max(most, d);
    }
    std::printf("%zu of %zu queries touch; farthest %.4f\n", touching, w.queries.size() - pairs, most);
    EXPECT_GT(touching, 0U);
    EXPECT_LT(touching, w.queries.size() / 2);
    EXPECT_LT(most, 0.3 * extent(w.bodies[0].vertices));
}

TEST(Proximity, StandsStillWithoutRotation) {
    const Workload w = proximity({{"rotation_step", 0}, {"gap", 0.1}});
    const double first = distance_of(w, w.queries[0]);
    EXPECT_EQ(distance_of(w, w.queries[(step_count - 1) * pairs]), first);
    EXPECT_NEAR(first, 0.1 * extent(w.bodies[0].vertices), 2e-3);
}

}  // namespace

}  // namespace edgewise::scene
