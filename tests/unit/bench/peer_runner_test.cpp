// SPDX-License-Identifier: MIT
//
// Another library as a runner: Edgewise's own GJK in world coordinates. Checks bodies and queries, answers in
// A's frame, caches that are kept and reset, and memory counts.
#include "edgewise/bench/peers/peer_modules.hpp"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdio>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/rounded.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/peers/peer_bench_for.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/canonical.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::bench {
namespace {

/// How often a query found its pair's cache warm.
int warm_starts = 0;
/// How often the verdict alone was asked.
int verdicts_alone = 0;

struct OwnGjk {
    struct Shape {
        explicit Shape(const Polyhedron& given) : body(given) {}
        Polyhedron body;
    };
    struct Placed {
        explicit Placed(const Pose& given) : pose(given) {}
        Pose pose;
    };
    struct Cache {
        SimplexPair<Canonical, Canonical> pair;
    };

    static peers::PeerAnswer query(const Shape& a, const Placed& at_a, const Shape& b, const Placed& at_b,
                                   Cache& cache, bool verdict_alone) {
        verdicts_alone += verdict_alone;
        warm_starts += cache.pair.count() > 0;
        const Distance found = to_world(
            Gjk::query(Canonical(a.body), Canonical(b.body), relative_pose(at_a.pose, at_b.pose), cache.pair),
            at_a.pose);
        return {true, found.status == Status::separated, found.distance, found.point_a, found.point_b};
    }
};

constexpr peers::PeerInfo own = {"own",       "f64", "Edgewise", "its GJK",
                                 "a simplex", "",    false,      peers::make_bench<OwnGjk>};
constexpr peers::PeerInfo own_single = {"own",       "f32", "Edgewise", "its GJK",
                                        "a simplex", "",    false,      peers::make_bench<OwnGjk>};
constexpr peers::PeerInfo own_mixed = {"own",       "mixed", "Edgewise", "its GJK",
                                       "a simplex", "",      false,      peers::make_bench<OwnGjk>};
scene::Workload workload_of(const char* scene, std::size_t queries) {
    return scene::make_scene(
               scene, scene::make_shape("sphere38").or_throw(),
               scene::complete_parameters(scene, {}).or_throw(), 1, queries,
               [](const Polyhedron& a, const Pose& pose_a, const Polyhedron& b, const Pose& pose_b) {
                   SimplexPair<Canonical, Canonical> cold;
                   return Gjk::query(Canonical(a), Canonical(b), relative_pose(pose_a, pose_b), cold)
                       .distance;
               })
        .or_throw();
}

/// Largest difference from exact distances, of bodies one wide; every verdict is right.
double worst_error(const Runner& runner, const scene::Workload& workload) {
    const std::vector<Distance> answers = runner.answer();
    double worst = 0;
    for (std::size_t i = 0; i < answers.size(); i += 7) {
        const scene::Query& query = workload.queries[i];
        const auto exact = truth::exact_distance(runner.stored_bodies()[query.body_a].vertices, query.pose_a,
                                                 runner.stored_bodies()[query.body_b].vertices, query.pose_b)
                               .or_throw();
        EXPECT_EQ(answers[i].status == Status::separated, exact.verdict == truth::ExactVerdict::separated);
        worst = std::max(worst, std::abs(answers[i].distance - exact.distance));
        if (answers[i].status != Status::separated) continue;
        const Transform<double> a_from_b = relative_pose(query.pose_a, query.pose_b);
        worst =
            std::max(worst, std::abs(norm(Vec3d(answers[i].point_b - answers[i].point_a)) - exact.distance));
        // In A's frame a witness lies no farther out than A's vertices.
        EXPECT_LE(norm(answers[i].point_a), 2);
        EXPECT_LE(norm(Vec3d(answers[i].point_b - a_from_b.translation)), 2);
    }
    return worst;
}

TEST(PeerRunner, GivesTheLibrarysAnswersInTheFrameOfA) {
    for (const char* scene : {"cold", "tumble"}) {
        const scene::Workload workload = workload_of(scene, 700);
        for (const peers::PeerInfo* info : {&own, &own_single}) {
            PeerRunner runner(*info);
            ASSERT_EQ(runner.load(workload), "");
            const double worst = worst_error(runner, workload);
            std::printf("peer runner, %s, %s: worst error %.3g\n", scene, info->precision, worst);
            EXPECT_LE(worst, 1e-14);
        }
    }
}

TEST(PeerRunner, AsksForTheVerdictAloneWhereNoMoreIsNeeded) {
    const scene::Workload workload = workload_of("cold", 20);
    for (const Needs needs : {Needs::verdict, Needs::distance}) {
        PeerRunner runner(own);
        RunnerOptions options;
        options.set_needs(needs);
        runner.configure(options);
        ASSERT_EQ(runner.load(workload), "");
        verdicts_alone = 0;
        static_cast<void>(runner.answer());
        EXPECT_EQ(verdicts_alone, needs == Needs::verdict ? 20 : 0);
    }
}

/// A library is asked for distances, also where the verdict alone is needed.
TEST(PeerRunner, TakesRadiiOffTheDistancesOfCores) {
    const scene::Workload workload = workload_of("cold", 100);
    PeerRunner runner(own);
    ASSERT_EQ(runner.load(workload), "");
    const std::vector<Distance> cores = runner.answer();
    verdicts_alone = 0;
    const double radius = 0.1 * extent(workload.bodies[0].vertices);
    for (const Needs needs : {Needs::verdict, Needs::distance}) {
        RunnerOptions options{.radius = 0.1};
        options.set_needs(needs);
        runner.configure(options);
        ASSERT_EQ(runner.load(workload), "");
        EXPECT_EQ(runner.margin(workload.queries[0]), 2 * radius);
        const std::vector<Distance> answers = runner.answer();
        int separated = 0;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            Distance expected = cores[i];
            add_radii(radius, radius, 0, expected);
            separated += expected.status == Status::separated;
            EXPECT_EQ(answers[i].status == Status::separated, expected.status == Status::separated);
            EXPECT_NEAR(answers[i].distance, expected.distance, 1e-14);
            if (expected.status != Status::separated) continue;
            EXPECT_LE(norm(Vec3d(answers[i].point_a - expected.point_a)), 1e-14);
            EXPECT_LE(norm(Vec3d(answers[i].point_b - expected.point_b)), 1e-14);
        }
        EXPECT_GT(separated, 10);
        EXPECT_LT(separated, 90);
    }
    EXPECT_EQ(verdicts_alone, 0);
}

TEST(PeerRunner, HoldsTheBodiesThatItsPrecisionStores) {
    scene::Workload workload = workload_of("cold", 10);
    for (Vec3d& v : workload.bodies[0].vertices) v *= 4.0 / 3.0;  // no single numbers any more
    for (const peers::PeerInfo* info : {&own, &own_single, &own_mixed}) {
        PeerRunner runner(*info);
        ASSERT_EQ(runner.load(workload), "");
        const Polyhedron& held = runner.stored_bodies()[0];
        EXPECT_EQ(held.vertices == workload.bodies[0].vertices, info == &own);
        if (info == &own) continue;
        for (const Vec3d& v : held.vertices) EXPECT_EQ(v, v.cast<float>().cast<double>());
    }
}

TEST(PeerRunner, KeepsCachesOfWarmScenesAndSetsThemBack) {
    const scene::Workload warm = workload_of("tumble", 600);
    PeerRunner runner(own);
    ASSERT_EQ(runner.load(warm), "");
    warm_starts = 0;
    const auto first = runner.answer();
    const int in_first = warm_starts;
    EXPECT_GT(in_first, 300);
    EXPECT_LT(in_first, 600);
    const auto pass = runner.prepared_range();
    pass(0, 600, nullptr);
    warm_starts = 0;
    pass(0, 600, nullptr);
    EXPECT_EQ(warm_starts, in_first) << "a pass starts from cold pairs";
    const scene::Workload cold = workload_of("cold", 600);
    ASSERT_EQ(runner.load(cold), "");
    warm_starts = 0;
    static_cast<void>(runner.answer());
    EXPECT_EQ(warm_starts, 0);
}

/// So a time does not depend on what was measured before it.
TEST(PeerRunner, ATimedPassFollowsOneThatIsNotTimedOrTwoShortOnes) {
    for (const auto& [queries, passes] : {std::pair{600, 3}, {3000, 2}}) {
        const scene::Workload warm = workload_of("tumble", static_cast<std::size_t>(queries));
        PeerRunner runner(own);
        ASSERT_EQ(runner.load(warm), "");
        warm_starts = 0;
        static_cast<void>(runner.answer());
        const int in_a_pass = warm_starts;
        warm_starts = 0;
        const measure::Timing timed = runner.time({}, 0);
        EXPECT_EQ(warm_starts, passes * in_a_pass) << queries;
        EXPECT_EQ(timed.either_queries + timed.first_queries, warm.queries.size());
    }
}

TEST(PeerRunner, CountsWhatShapesAllocate) {
    const scene::Workload workload = workload_of("cold", 10);
    PeerRunner runner(own);
    ASSERT_EQ(runner.load(workload), "");
    const Polyhedron& body = workload.bodies[0];
    // The vectors of a copied body, and what the allocator adds to each: a word or two.
    const std::size_t vectors =
        sizeof(Vec3d) * body.vertices.size() + sizeof(PolyhedronEdge) * body.edges.size() +
        sizeof(Plane<double>) * body.face_planes.size() +
        sizeof(Index) * (body.input_index.size() + body.face_offset.size() + body.face_ring.size() +
                         body.vertex_offset.size() + body.vertex_ring.size());
    // Under sanitizers the heap is another, which counts nothing.
    if (mallinfo2().uordblks > 0) {
        EXPECT_GE(runner.ledger().total(), vectors);
        EXPECT_LE(runner.ledger().total(), vectors + 9 * 32);
    } else {
        EXPECT_EQ(runner.ledger().total(), 0U);
    }
    EXPECT_EQ(runner.object_bytes(), sizeof(OwnGjk::Shape));
    EXPECT_EQ(runner.pair_bytes(), sizeof(OwnGjk::Cache));
    EXPECT_EQ(runner.build_times(3).build_ns.size(), 3U);
    EXPECT_EQ(runner.answer().size(), 10U) << "shapes timed are not those that answer";
}

}  // namespace
}  // namespace edgewise::bench
