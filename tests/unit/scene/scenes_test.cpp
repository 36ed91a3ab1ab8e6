// SPDX-License-Identifier: MIT
//
// Every scene: the regime it promises, reached and printed; the order of its queries; the same bits from the
// same seed; and clear refusals. Distances by brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "edgewise/scene/kinds/scene_setup.hpp"
#include "edgewise/scene/recording.hpp"
#include "made_scene.hpp"

namespace edgewise::scene {
namespace {

Polyhedron shape(const char* name) { return make_shape(name).or_throw(); }

/// Share of overlapping pairs among every tenth query, because brute force is slow.
double overlap_share(const Workload& w) {
    std::size_t overlapping = 0, asked = 0;
    for (std::size_t i = 0; i < w.queries.size(); i += 10)
        ++asked, overlapping += distance_of(w, w.queries[i]) == 0;
    return static_cast<double>(overlapping) / static_cast<double>(asked);
}

/// FNV-1a, a word at a time, over the bits of all poses.
std::uint64_t hash_of(const Workload& w) {
    std::uint64_t hash = 0xcbf29ce484222325;
    const auto add = [&hash](double number) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(number)) * 0x100000001b3;
    };
    for (const Query& q : w.queries) {
        for (const Pose* pose : {&q.pose_a, &q.pose_b}) {
            std::for_each_n(pose->rotation.data(), 9, add);
            std::for_each_n(pose->translation.data(), 3, add);
        }
    }
    return hash;
}

void expect_well_formed(const Workload& w, std::size_t count) {
    ASSERT_EQ(w.queries.size(), count);
    std::uint32_t expected = 0;
    for (const Query& q : w.queries) {
        ASSERT_TRUE(q.pair == expected || q.pair == expected + 1) << "slots follow one another without gaps";
        expected = q.pair;
        ASSERT_LT(q.body_a, w.bodies.size());
        ASSERT_LT(q.body_b, w.bodies.size());
        ASSERT_LT(ortho_error(q.pose_a.rotation), 4e-15);
        ASSERT_LT(ortho_error(q.pose_b.rotation), 4e-15);
    }
    EXPECT_EQ(w.pair_count, expected + 1);
}

TEST(Static, FillsItsBoxToTenPercentWithSeveralSizes) {
    const Polyhedron body = shape("sphere38");
    const Workload w = made_scene("static", body, 3000);
    expect_well_formed(w, 3000);
    EXPECT_EQ(w.pair_count, 3000U) << "every pair its own slot";
    double reached = 0, total = 0;
    std::set<std::uint32_t> seen;
    for (const Query& q : w.queries) {
        seen.insert({q.body_a, q.body_b});
        const Vec3d centre = q.pose_a.apply(vertex_mean(w.bodies[q.body_a].vertices));
        reached = std::max(reached, max_abs(centre));
        EXPECT_TRUE(
            world_box(w.bodies[q.body_a], q.pose_a).overlaps(world_box(w.bodies[q.body_b], q.pose_b)));
    }
    for (int i = 0; i < 64; ++i) total += volume(w.bodies[static_cast<std::size_t>(i % 4)]);
    const double occupancy = total / std::pow(2 * reached, 3);
    const double share = overlap_share(w);
    std::printf("static: occupancy %.4f (box from the outermost centre), %zu sizes, %.1f %% overlap\n",
                occupancy, seen.size(), 100 * share);
    EXPECT_NEAR(occupancy, 0.1, 0.002);
    EXPECT_EQ(seen.size(), 4U);
    EXPECT_GT(volume(w.bodies[3]) / volume(w.bodies[0]), 7.9);
    EXPECT_GT(share, 0.3);
    EXPECT_LT(share, 0.7);
}

TEST(Cold, DistancesAreUniformInOneBodySizeAndATenthOverlaps) {
    std::size_t evaluations = 0;
    const DistanceFunction counting = [&](auto& a, auto& pose_a, auto& b, auto& pose_b) {
        return ++evaluations, truth::brute_force_distance(a, pose_a, b, pose_b);
    };
    for (const char* name : {"tetra4", "cube8", "sphere38"}) {
        const Polyhedron body = shape(name);
        evaluations = 0;
        const Result<Workload> w = make_scene("cold", body, {}, 2, 1000, counting);
        ASSERT_TRUE(w) << w.error;
        expect_well_formed(*w, 1000);
        double overlapping = 0, sum = 0, largest = 0;
        for (const Query& q : w->queries) {
            const double d = distance_of(*w, q) / extent(body.vertices);
            overlapping += d == 0, sum += d, largest = std::max(largest, d);
        }
        const double separated = 1000 - overlapping, mean = sum / separated;
        std::printf(
            "cold %-8s: %.1f %% overlap; distance mean %.3f, largest %.4f body sizes; %zu evaluations\n",
            name, overlapping / 10, mean, largest, evaluations);
        EXPECT_NEAR(overlapping, 100, 30);
        EXPECT_NEAR(mean, 0.5, 5 * std::sqrt(1.0 / 12 / separated));
        EXPECT_GT(largest, 0.98);
        EXPECT_LT(largest, 1.001);
        EXPECT_LT(evaluations, 10000U);
    }
}

TEST(Cold, OverlapsAreFromContactToHalfTheContactDistance) {
    const Polyhedron body = shape("sphere38");
    const Workload w = made_scene("cold", body, 300, {{"overlapping", 1}}, 3);
    const Vec3d centre = vertex_mean(body.vertices);
    double nearest = 9, farthest = 0;
    std::size_t overlapping = 0;
    for (const Query& q : w.queries) {
        const double apart = norm(Vec3d(q.pose_b.apply(centre) - q.pose_a.apply(centre)));
        nearest = std::min(nearest, apart), farthest = std::max(farthest, apart);
        overlapping += distance_of(w, q) == 0;
    }
    std::printf("cold, all overlapping: %zu of 300; centres %.3f .. %.3f m apart (radius about 1 m)\n",
                overlapping, nearest, farthest);
    EXPECT_GE(overlapping, 297U);  // the shallowest may miss by the placement tolerance
    EXPECT_GT(nearest, 0.9);
    EXPECT_LT(nearest, 1.1);
    EXPECT_GT(farthest, 1.85);
    EXPECT_LT(farthest, 2.05);
}

TEST(Cold, HoldsItsTargetForAFarOffBody) {
    // A mesh far from its origin: the pose must turn it about its own middle, not swing it around the world.
    Polyhedron body = shape("cube8");
    for (Vec3d& v : body.vertices) v += Vec3d(100, -50, 25);
    for (Plane<double>& p : body.face_planes) p.offset -= dot(p.normal, Vec3d(100, -50, 25));
    const Workload w = made_scene("cold", body, 200, {{"overlapping", 0}, {"distance", 0.5}});
    double largest = 0, away = 0;
    for (const Query& q : w.queries) {
        largest = std::max(largest, distance_of(w, q) / extent(body.vertices));
        away = std::max(away, max_abs(q.pose_b.apply(body.vertices[0])));
    }
    std::printf("cold, far-off body: largest distance %.4f of at most 0.5; reaches %.1f m from the origin\n",
                largest, away);
    EXPECT_GT(largest, 0.48);
    EXPECT_LT(largest, 0.501);
    EXPECT_LT(away, 10);
}

/// What happens from query to query inside the slots of a tumble workload.
struct Steps {
    std::size_t followed = 0;  ///< queries with a predecessor in their slot
    double worst_angle = 0, longest_way = 0, mean_way = 0;
};

Steps measure_steps(const Workload& w, double angle) {
    Steps steps;
    const Vec3d centre = vertex_mean(w.bodies[0].vertices);
    for (std::size_t i = 1; i < w.queries.size(); ++i) {
        const Query &before = w.queries[i - 1], &after = w.queries[i];
        if (before.pair != after.pair) continue;
        ++steps.followed;
        for (const auto& [from, to] :
             {std::pair{before.pose_a, after.pose_a}, {before.pose_b, after.pose_b}}) {
            const double turned = angle_between(from.rotation, to.rotation);
            steps.worst_angle = std::max(steps.worst_angle, std::abs(turned - angle));
            const double way = norm(Vec3d(to.apply(centre) - from.apply(centre)));
            steps.longest_way = std::max(steps.longest_way, way);
            steps.mean_way += way;
        }
    }
    steps.mean_way /= 2 * static_cast<double>(steps.followed);
    return steps;
}

TEST(Tumble, EveryBodyMovesByItsStepEveryStep) {
    const Polyhedron body = shape("sphere38");
    const double size = extent(body.vertices);
    for (const double angle : {0.01, 1.0}) {
        for (const double way : {0.005, 0.2}) {
            const Workload w =
                made_scene("tumble", body, 4000, {{"rotation_step", angle}, {"translation_step", way}});
            expect_well_formed(w, 4000);
            const Steps steps = measure_steps(w, angle);
            std::printf(
                "tumble %.2f rad, %.3f sizes a step: %zu of 4000 followed, %u slots, worst |angle - asked| "
                "%.1e, way %.5f sizes (mean), %.5f (longest)\n",
                angle, way, steps.followed, w.pair_count, steps.worst_angle, steps.mean_way / size,
                steps.longest_way / size);
            EXPECT_LT(steps.worst_angle, 3e-15);
            EXPECT_LT(steps.longest_way / size, way * (1 + 1e-9)) << "only a wall may shorten the way";
            EXPECT_GT(steps.mean_way / size, way * 0.9);
            EXPECT_GT(steps.followed, way < 0.1 ? 3600U : 1500U);
        }
    }
}

TEST(Tumble, FiveToThirtyPercentOverlapForEveryShape) {
    for (const char* name : {"tetra4", "cube8", "sphere38"}) {
        const double share = overlap_share(made_scene("tumble", shape(name), 10000));
        std::printf("tumble %-8s: %.1f %% overlap\n", name, 100 * share);
        EXPECT_GT(share, 0.05) << name;
        EXPECT_LT(share, 0.30) << name;
    }
}

TEST(Tumble, APairThatReturnsGetsANewSlot) {
    const Polyhedron body = shape("cube8");
    const Workload w = made_scene("tumble", body, 4000, {{"steps", 1000000}, {"translation_step", 0.05}});
    std::printf("tumble: %u slots among the 66 pairs of one population\n", w.pair_count);
    EXPECT_GT(w.pair_count, 66U);
    // Within a slot every body has moved by one step, no more: no query of the stay is missing.
    EXPECT_LT(measure_steps(w, 0.01).longest_way, 0.05 * extent(body.vertices) * (1 + 1e-9));
}

TEST(Scenes, OneSeedOneWorkload) {
    const Polyhedron body = shape("sphere38");
    const std::map<std::string, std::uint64_t> golden = {
        {"static", 0x893bd2e00cc3aca7U},    {"cold", 0xcdc5428cd9779aa9U},
        {"gap", 0x8bcdea69156a40e8U},       {"tumble", 0x64db073872c93f51U},
        {"proximity", 0xa9fd913d7cc1f7e5U}, {"pressure", 0x4001d7fcbcf5fd18U},
        {"resting", 0x5eb77ed4daa9b151U}};
    for (const SceneInfo& info : list_scenes()) {
        if (info.name == recorded_kind) continue;  // made from a file, without a seed
        const Workload w = made_scene(info.name.c_str(), body, 500, {}, 42);
        const std::uint64_t hash = hash_of(w);
        std::printf("hash of %s: %016llx\n", info.name.c_str(), static_cast<unsigned long long>(hash));
        EXPECT_EQ(hash, hash_of(made_scene(info.name.c_str(), body, 500, {}, 42)));
        EXPECT_NE(hash, hash_of(made_scene(info.name.c_str(), body, 500, {}, 43)));
        EXPECT_EQ(hash, golden.at(info.name)) << info.name;
        EXPECT_EQ(info.warm, info.name != "static" && info.name != "cold" && info.name != "gap");
        EXPECT_EQ(w.table_each, info.name == "pressure");
        for (const Query& q : w.queries) {
            ASSERT_LT(std::max(q.instance_a, q.instance_b), w.instances.size()) << info.name;
            EXPECT_EQ(w.instances[q.instance_a], q.body_a) << info.name;
            EXPECT_EQ(w.instances[q.instance_b], q.body_b) << info.name;
            EXPECT_NE(q.instance_a, q.instance_b) << info.name;
        }
        EXPECT_EQ(info.warm, w.warm);
    }
}

TEST(Scenes, ExactlyAsManyQueriesAsAsked) {
    const Polyhedron body = shape("cube8");
    for (const char* name : {"static", "cold", "gap", "tumble"}) {
        for (const std::size_t count : {1U, 2U, 37U})
            expect_well_formed(made_scene(name, body, count), count);
    }
}

/// Larger boxes meet more often, so that the same populations have more pairs, which lie farther apart.
TEST(Static, AMarginAsksMorePairsOfEachPopulation) {
    const auto in_populations = [](double margin) {
        const auto w = make_scene("static", *make_shape("cube8"), {{"margin", margin}}, 1, 2000, {});
        EXPECT_TRUE(w) << w.error;
        std::size_t populations = 1;
        for (std::size_t i = 1; i < w->queries.size(); ++i)
            populations += w->queries[i].instance_a < w->queries[i - 1].instance_a;
        return populations;
    };
    EXPECT_LT(in_populations(0.2), in_populations(0));
}

TEST(Scenes, DefaultsCompleteTheIdentity) {
    const Result<SceneParameters> p = complete_parameters("tumble", {{"rotation_step", 0.5}});
    ASSERT_TRUE(p) << p.error;
    EXPECT_EQ(p->size(), 15U);
    EXPECT_TRUE(p->at("rotation_step") == 0.5 && p->at("occupancy") == 0.1);
}

void expect_refusal(const char* name, const SceneParameters& given, std::size_t count,
                    std::initializer_list<const char*> parts) {
    const Result<Workload> w =
        make_scene(name, *make_shape("cube8"), given, 1, count, truth::brute_force_distance);
    ASSERT_FALSE(w) << name;
    for (const char* part : parts) EXPECT_NE(w.error.find(part), std::string::npos) << w.error;
    EXPECT_EQ(w.error.find('\n'), std::string::npos);
}

TEST(Scenes, BadRequestsSayWhatIsRight) {
    expect_refusal("boil", {}, 1, {"'boil'", "static", "cold", "tumble"});
    expect_refusal("tumble", {{"speed", 1}}, 1, {"'speed'", "rotation_step", "translation_step"});
    expect_refusal("tumble", {{"rotation_step", -1}}, 1, {"rotation_step", "-1", "rad"});
    expect_refusal("tumble", {{"rotation_step", std::nan("")}}, 1, {"rotation_step", "nan"});
    expect_refusal("tumble", {{"bodies", 2.5}}, 1, {"bodies", "2.5", "whole"});
    expect_refusal("static", {{"occupancy", 0}}, 1, {"occupancy", "out of bounds"});
    expect_refusal("cold", {}, 0, {"queries"});
    const Result<Workload> w = make_scene("cold", *make_shape("cube8"), {}, 1, 1, {});
    ASSERT_FALSE(w);
    EXPECT_NE(w.error.find("distance function"), std::string::npos);
}

TEST(Scenes, ABarrenSceneEndsWithAReason) {
    expect_refusal(
        "tumble",
        {{"bodies", 2}, {"occupancy", 0.001}, {"margin", 0}, {"translation_step", 0}, {"steps", 1e6}}, 1,
        {"raise occupancy"});
}

}  // namespace

}  // namespace edgewise::scene
