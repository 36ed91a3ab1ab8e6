// SPDX-License-Identifier: MIT
//
// Adapters of libraries without a Debian package, on stubs that answer with the distance of the bodies'
// centres (twice that distance if their cache is warm). Checks that vertices, faces, poses, the order of the
// two bodies, and caches arrive.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/peers/peer.hpp"
#include "stubbed_peers.hpp"

namespace edgewise::peers {
namespace {

/// A prism with its centre at the mean of its vertices and in the middle of its box. Single precision holds
/// its coordinates exactly.
Polyhedron prism(int sides, double height, const Vec3d& centre) {
    std::vector<Vec3d> points;
    for (int i = 0; i < sides / 2; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        const auto coarse = [](double x) { return std::round(x * 65536) / 65536; };
        const Vec3d corner(coarse(std::cos(angle)), coarse(std::sin(angle)), height);
        for (const double up : {1, -1}) {
            points.push_back(centre + up * corner);
            points.push_back(centre + up * Vec3d(-corner.x(), -corner.y(), height));
        }
    }
    return convex_hull(points).or_throw();
}

Pose pose(double angle, const Vec3d& axis, const Vec3d& translation) {
    return {Mat3d(Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix()), translation};
}

const std::array<Vec3d, 3> centres = {Vec3d(0.5, -1, 2), Vec3d(-3, 0.25, 1), Vec3d(1, 1, 1)};
const std::array<Polyhedron, 3> bodies = {prism(6, 0.5, centres[0]), prism(4, 2, centres[1]),
                                          prism(150, 0.75, centres[2])};

/// Two pairs; the second has a body with more vertices than an index of 8 bits can name.
const std::vector<PeerQuery> queries = {
    {0, 1, 0, pose(0.7, {1, 2, 3}, {4, -2, 1}), pose(2.1, {-1, 0.5, 2}, {-5, 1, 3})},
    {2, 0, 1, pose(1.3, {3, -1, 1}, {2, 6, -4}), pose(-0.4, {0, 1, 1}, {-1, -2, 5})},
};

Vec3d centre_a(const PeerQuery& query) { return query.pose_a.apply(centres[query.shape_a]); }
Vec3d centre_b(const PeerQuery& query) { return query.pose_b.apply(centres[query.shape_b]); }
double distance_of(const PeerQuery& query) { return norm(Vec3d(centre_a(query) - centre_b(query))); }

struct Adapter {
    const PeerInfo* info;
    std::unique_ptr<PeerBench> bench;

    [[nodiscard]] double tolerance() const {
        return std::string_view(info->precision) == "f32" ? 1e-5 : 1e-12;
    }
    [[nodiscard]] bool has_cache() const { return std::string_view(info->cache) != "nothing"; }
    [[nodiscard]] std::vector<PeerAnswer> answers(std::size_t first, std::size_t last) const {
        std::vector<PeerAnswer> found(last);
        bench->run(first, last, found.data());
        return found;
    }
};

/// All modules that were built, with their shapes.
std::vector<Adapter> adapters() {
    std::vector<Adapter> result;
    for (const auto& entry : std::filesystem::directory_iterator(stubbed_peers)) {
        void* module = dlopen(entry.path().c_str(), RTLD_NOW | RTLD_LOCAL);
        void* symbol = module ? dlsym(module, peer_symbol) : nullptr;
        EXPECT_TRUE(symbol) << dlerror();
        if (!symbol) continue;
        const PeerInfo* info = reinterpret_cast<PeerFunction>(symbol)();
        EXPECT_EQ(entry.path().stem(), info->name + std::string("_") + info->precision);
        result.push_back({info, std::unique_ptr<PeerBench>(info->make())});
        const std::array<const Polyhedron*, 3> given = {&bodies[0], &bodies[1], &bodies[2]};
        result.back().bench->make_shapes(given);
    }
    EXPECT_EQ(result.size(), 7U);
    return result;
}

TEST(PeerAdapters, AnswerForTheGivenBodiesAndPosesInTheWorld) {
    for (const Adapter& adapter : adapters()) {
        adapter.bench->prepare(queries, 0, false);
        const auto answers = adapter.answers(0, queries.size());
        for (std::size_t i = 0; i < queries.size(); ++i) {
            SCOPED_TRACE(adapter.info->name + std::string(", query ") + std::to_string(i));
            EXPECT_TRUE(answers[i].answered && answers[i].separated);
            EXPECT_NEAR(answers[i].distance, distance_of(queries[i]), adapter.tolerance());
            EXPECT_LE(norm(Vec3d(answers[i].point_a - centre_a(queries[i]))), adapter.tolerance());
            EXPECT_LE(norm(Vec3d(answers[i].point_b - centre_b(queries[i]))), adapter.tolerance());
        }
    }
}

TEST(PeerAdapters, KeepEachPairsCacheUntilItIsSetBack) {
    const std::vector<PeerQuery> twice = {queries[0], queries[1], queries[0], queries[1]};
    for (const Adapter& adapter : adapters()) {
        SCOPED_TRACE(adapter.info->name);
        const auto doubled = [&](const PeerAnswer& answer, std::size_t i) {
            return answer.distance > 1.5 * distance_of(twice[i]);
        };
        adapter.bench->prepare(twice, 2, false);
        for (int pass = 0; pass < 2; ++pass) {
            const auto answers = adapter.answers(0, 4);
            EXPECT_FALSE(doubled(answers[0], 0));
            EXPECT_FALSE(doubled(answers[1], 1));
            EXPECT_EQ(doubled(answers[2], 2), adapter.has_cache());
            const bool too_large = std::string_view(adapter.info->name) == "box3d";
            EXPECT_EQ(doubled(answers[3], 3), adapter.has_cache() && !too_large);
            adapter.bench->set_back();
        }
        adapter.bench->prepare(twice, 0, false);
        for (const PeerAnswer& answer : adapter.answers(0, 3))
            EXPECT_LT(answer.distance, 1.5 * distance_of(twice[0]));
    }
}

TEST(PeerAdapters, TellThatBodiesTouch) {
    const PeerQuery same{0, 0, 0, Pose{}, Pose{}};
    for (const Adapter& adapter : adapters()) {
        SCOPED_TRACE(adapter.info->name);
        for (const bool verdict_alone : {false, true}) {
            adapter.bench->prepare(std::span(&same, 1), 1, verdict_alone);
            const PeerAnswer answer = adapter.answers(0, 1)[0];
            EXPECT_TRUE(answer.answered);
            EXPECT_FALSE(answer.separated);
            EXPECT_EQ(answer.distance, 0);
        }
    }
}

TEST(PeerAdapters, GiveAVerdictAloneInTheirOwnWay) {
    const std::set<std::string_view> by_distance = {"open_gjk", "physx"};
    for (const Adapter& adapter : adapters()) {
        SCOPED_TRACE(adapter.info->name);
        adapter.bench->prepare(queries, 2, true);
        const PeerAnswer answer = adapter.answers(0, queries.size())[0];
        EXPECT_TRUE(answer.answered && answer.separated);
        EXPECT_EQ(answer.distance > 0, by_distance.contains(adapter.info->name));
    }
}

}  // namespace
}  // namespace edgewise::peers
