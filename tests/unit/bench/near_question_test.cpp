// SPDX-License-Identifier: MIT
//
// Compares a runner that is asked for nearness with brute force on every query of coherent and random scenes.
// The margins are below, at and above the distances that occur. Also checks how much the runner reads.
#include "edgewise/bench/near_question.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "brute_force.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::bench {
namespace {

struct Scene {
    const char *name, *kind, *shape;
    scene::SceneParameters parameters;
    bool b_alone = false;  ///< only body B turns, in its place: no point moves but by the turn
};

const Scene coherent{"coherent", "tumble", "sphere18", {{"rotation_step", 0.02}, {"in_time_order", 1}}};
const Scene turning{"turning", "tumble", "cube8", {{"rotation_step", 0.05}}, true};
const Scene random_turns{"random", "tumble", "cube8", {{"random_orientation", 1}, {"rotation_step", 0}}};
const Scene cold_scene{"cold", "cold", "cube8", {{"overlapping", 0.3}}};

studies::SingleCell cell_of(const Scene& scene, const std::string& table, const std::string& algorithm,
                            double margin, Needs needs = Needs::nearer) {
    return studies::SingleCell(
        {table, algorithm, scene.kind, scene.shape, scene.parameters, 600, 3, needs, margin});
}

/// Every A, and the place of every B, as in the pair's first query.
void turn_b_alone(scene::Workload& workload) {
    std::map<std::uint32_t, scene::Query> first;
    for (scene::Query& query : workload.queries) {
        const scene::Query& start = first.try_emplace(query.pair, query).first->second;
        query.pose_a = start.pose_a;
        query.pose_b.translation = start.pose_b.translation;
    }
}

/// A scene's queries, asked for nearness on one table type.
class Subject {
  public:
    Subject(const Scene& scene, const std::string& table, std::string algorithm)
        : cell_(cell_of(scene, table, algorithm, 1)),
          workload_(cell_.workload()),
          algorithm_(std::move(algorithm)) {
        if (scene.b_alone) turn_b_alone(workload_);
    }

    [[nodiscard]] const scene::Workload& workload() const { return workload_; }

    [[nodiscard]] std::unique_ptr<Runner> runner(double margin, Needs needs = Needs::nearer) const {
        auto made = cell_.type().make_runner(algorithm_);
        made->configure({.needs = needs, .margin = margin});
        EXPECT_EQ(made->load(workload_), "");
        return made;
    }

    /// Returns the exact distance of every query, for the bodies as the tables hold them.
    [[nodiscard]] std::vector<double> true_distances() const {
        const auto bodies = cell_.runner().stored_bodies();
        std::vector<double> distances;
        for (const scene::Query& query : workload_.queries)
            distances.push_back(truth::brute_force_distance(bodies[query.body_a], query.pose_a,
                                                            bodies[query.body_b], query.pose_b));
        return distances;
    }

  private:
    studies::SingleCell cell_;
    scene::Workload workload_;
    std::string algorithm_;
};

/// Below all distances, at some of them, above all; over the extent.
std::vector<double> margins_around(std::vector<double> distances, double extent) {
    std::erase(distances, 0.0);
    std::sort(distances.begin(), distances.end());
    std::vector<double> margins = {0.5 * distances.front() / extent, 2 * distances.back() / extent};
    for (const std::size_t quarter : {1U, 2U, 3U})
        margins.push_back(distances[quarter * distances.size() / 4] / extent);
    return margins;
}

struct Tally {
    int told_near = 0, told_far = 0, asked_near = 0, asked_far = 0, wrong = 0;
    double worst = 0;  ///< how far beyond its margin a bad verdict's pair is

    [[nodiscard]] int told() const { return told_near + told_far; }
    [[nodiscard]] int asked() const { return asked_near + asked_far; }
};

void add(const Subject& subject, double part, const std::vector<double>& truth, double doubt, Tally& tally) {
    const auto runner = subject.runner(part);
    const std::vector<Distance> answers = runner->answer();
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const bool nearer = answers[i].status == Status::touching, told = answers[i].steps == 0;
        ASSERT_TRUE(nearer || answers[i].status == Status::separated) << i;
        const double margin = runner->margin(subject.workload().queries[i]);
        EXPECT_EQ(answers[i].distance, nearer ? 0 : margin);
        ++(told ? (nearer ? tally.told_near : tally.told_far)
                : (nearer ? tally.asked_near : tally.asked_far));
        if (nearer == (truth[i] < margin)) continue;
        tally.worst = std::max(tally.worst, std::abs(truth[i] - margin));
        tally.wrong += std::abs(truth[i] - margin) > doubt;
    }
}

/// Over margins below, at and above the scene's distances.
Tally tally_of(const Scene& scene, const std::string& table, const std::string& algorithm) {
    const Subject subject(scene, table, algorithm);
    const std::vector<double> truth = subject.true_distances();
    const double size = extent(subject.workload().bodies[0].vertices);
    const bool single = table.ends_with("f32");
    const double doubt = 16 * size * (single ? Tolerance<float>::eps : Tolerance<double>::eps);
    Tally tally;
    for (const double margin : margins_around(truth, size)) add(subject, margin, truth, doubt, tally);
    std::printf("%s, %s %s: from bounds near %d, far %d; asked near %d, far %d; wrong by %.2g at most\n",
                scene.name, table.c_str(), algorithm.c_str(), tally.told_near, tally.told_far,
                tally.asked_near, tally.asked_far, tally.worst);
    return tally;
}

class NearQuestion : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(NearQuestion, IsNeverWrongWhateverTheMotion) {
    const auto [table, algorithm] = GetParam();
    for (const Scene* scene : {&coherent, &turning}) {
        const Tally tally = tally_of(*scene, table, algorithm);
        EXPECT_EQ(tally.wrong, 0) << scene->name;
        for (const int visited : {tally.told_near, tally.told_far, tally.asked_near, tally.asked_far})
            EXPECT_GT(visited, 0) << scene->name;
        EXPECT_GT(tally.told(), tally.asked()) << scene->name;
    }
    // Bodies can turn by any angle between two queries, so bounds decide few queries.
    const Tally turned = tally_of(random_turns, table, algorithm);
    EXPECT_EQ(turned.wrong, 0);
    for (const int visited : {turned.told_near, turned.asked_near, turned.asked_far}) EXPECT_GT(visited, 0);
    const Tally tally = tally_of(cold_scene, table, algorithm);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_EQ(tally.told(), 0) << "a cold query has no past";
    EXPECT_GT(tally.asked_near, 0);
    EXPECT_GT(tally.asked_far, 0);
}

TEST_P(NearQuestion, WithinItsMarginGivesTheDistance) {
    const auto [table, algorithm] = GetParam();
    const double eps = std::string(table).ends_with("f32") ? Tolerance<float>::eps : Tolerance<double>::eps;
    for (const Scene* scene : {&coherent, &random_turns, &cold_scene}) {
        const Subject subject(*scene, table, algorithm);
        const std::vector<double> truth = subject.true_distances();
        const double size = extent(subject.workload().bodies[0].vertices), doubt = 16 * size * eps;
        int near = 0, beyond = 0, told = 0;
        double worst = 0;
        for (const double part : margins_around(truth, size)) {
            const auto runner = subject.runner(part, Needs::within);
            const std::vector<Distance> answers = runner->answer();
            for (std::size_t i = 0; i < answers.size(); ++i) {
                const double margin = runner->margin(subject.workload().queries[i]);
                const bool is_beyond =
                    answers[i].status == Status::separated && answers[i].distance >= margin;
                if (std::abs(truth[i] - margin) > doubt) {
                    ASSERT_EQ(is_beyond, truth[i] > margin) << i;
                }
                if (!is_beyond) worst = std::max(worst, std::abs(answers[i].distance - truth[i]) / size);
                ++(is_beyond ? beyond : near);
                told += answers[i].steps == 0;
            }
        }
        std::printf("%s, %s %s: %d within, %d beyond, %d of them from bounds; off by %.2g of the size\n",
                    scene->name, table, algorithm, near, beyond, told, worst);
        EXPECT_LE(worst, 16 * eps);
        EXPECT_GT(std::min(near, beyond), 500);
        EXPECT_LE(told, beyond) << "bounds give no distance";
        EXPECT_EQ(told > 0, scene == &coherent) << "other pairs turn too far for their bounds";
    }
}

/// Counts the accesses of each query to tables and to the cache of its pair, and the bytes of that cache.
class PerQuery final : public measure::TraceListener {
  public:
    struct Seen {
        int table_reads = 0, cache_reads = 0, cache_writes = 0;
        std::uint32_t cache_bytes = 0;
    };

    void on_access(const measure::TracedAccess& access) override {
        if (access.side != measure::TraceSide::scene) {
            ++now_.table_reads;
        } else if (access.field == pair_cache_field) {
            ++(access.kind == measure::AccessKind::read ? now_.cache_reads : now_.cache_writes);
            now_.cache_bytes += access.bytes;
        }
    }
    void on_query_end(bool) override {
        seen.push_back(now_);
        now_ = {};
    }

    std::vector<Seen> seen;

  private:
    Seen now_;
};

TEST_P(NearQuestion, ReadsNoTableWhereBoundsTell) {
    const auto [table, algorithm] = GetParam();
    for (const auto& [scene, needs] : {std::pair{&coherent, Needs::nearer},
                                       {&coherent, Needs::within},
                                       {&cold_scene, Needs::nearer},
                                       {&cold_scene, Needs::within}}) {
        const studies::SingleCell cell = cell_of(*scene, table, algorithm, 0.2, needs);
        const std::vector<Distance> answers = cell.runner().answer();
        std::vector<Distance> traced(answers.size());
        PerQuery reads;
        cell.runner().trace(answers.size() + 1, reads, traced.data());
        ASSERT_EQ(reads.seen.size(), answers.size());
        const auto whole = static_cast<std::uint32_t>(cell.runner().pair_bytes());
        int told = 0;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const PerQuery::Seen& seen = reads.seen[i];
            EXPECT_EQ(traced[i].status, answers[i].status) << i;
            EXPECT_EQ(traced[i].distance, answers[i].distance) << i;
            EXPECT_EQ(traced[i].steps, answers[i].steps) << "the same path";
            const bool by_bounds = answers[i].steps == 0, warm = cell.workload().warm;
            EXPECT_EQ(seen.table_reads == 0, by_bounds) << i;
            EXPECT_EQ(seen.cache_writes, warm && !by_bounds) << i;
            EXPECT_EQ(seen.cache_reads, warm) << i;
            EXPECT_EQ(seen.cache_bytes, !warm ? 0 : by_bounds ? sizeof(DistanceBounds) : 2 * whole) << i;
            told += by_bounds;
        }
        EXPECT_EQ(told > 0, scene == &coherent);
        EXPECT_LT(told, static_cast<int>(answers.size()));
        double sum = 0;
        for (const Distance& answer : answers) sum += answer.distance;
        EXPECT_EQ(cell.runner().prepared_pass()().distances, sum) << "the sum includes answers from bounds";
    }
}

INSTANTIATE_TEST_SUITE_P(Of, NearQuestion,
                         testing::Values(std::pair{"aos_f64", "vclip"}, std::pair{"lean_f64", "gjk"},
                                         std::pair{"lean_f32", "vclip"}, std::pair{"lean_f32", "gjk"}),
                         [](const auto& of) { return std::string(of.param.first) + "_" + of.param.second; });

TEST(NearMargin, IsOfTheLargerBodyAndTheSameForEveryTable) {
    const studies::SingleCell cell({"lean_f32", "gjk", "static", "cube8", {}, 400, 1, Needs::nearer, 0.25});
    const scene::Workload& workload = cell.workload();
    ASSERT_GT(workload.bodies.size(), 1U) << "of several sizes";
    int mixed = 0;
    for (const scene::Query& query : workload.queries) {
        const double a = extent(workload.bodies[query.body_a].vertices);
        const double b = extent(workload.bodies[query.body_b].vertices);
        EXPECT_EQ(cell.runner().margin(query), 0.25 * std::max(a, b));
        mixed += a != b;
    }
    EXPECT_GT(mixed, 0);
}

/// Runners compute in a unit of their own where bodies are far from 1.
TEST(NearMargin, IsInTheBodiesOwnUnit) {
    const studies::SingleCell cell = cell_of(coherent, "lean_f64", "gjk", 0.2);
    scene::Workload large = cell.workload();
    for (Polyhedron& body : large.bodies) body = scene::scaled(body, 0x1p40);
    for (scene::Query& query : large.queries) {
        query.pose_a.translation *= 0x1p40;
        query.pose_b.translation *= 0x1p40;
    }
    const auto runner = cell.type().make_runner("gjk");
    runner->configure({.needs = Needs::nearer, .margin = 0.2});
    ASSERT_EQ(runner->load(large), "");
    const auto answers = cell.runner().answer(), of_large = runner->answer();
    for (std::size_t i = 0; i < answers.size(); ++i) {
        EXPECT_EQ(of_large[i].status, answers[i].status) << i;
        EXPECT_EQ(of_large[i].distance, 0x1p40 * answers[i].distance) << i;
    }
}

TEST(NearPass, CountsTheBoundsAmongWhatAPairKeeps) {
    const studies::SingleCell near = cell_of(coherent, "lean_f64", "gjk", 0.2);
    const studies::SingleCell plain({"lean_f64", "gjk", "tumble", "sphere18", coherent.parameters, 600, 3});
    EXPECT_GE(near.runner().pair_bytes(), plain.runner().pair_bytes() + sizeof(DistanceBounds));
}

TEST(NearPass, TimesAllAsOfEitherKind) {
    const studies::SingleCell cell = cell_of(coherent, "lean_f64", "gjk", 0.2);
    const measure::Timing timing = cell.runner().time({}, 0);
    std::size_t warm = 0;
    for (const std::uint8_t cold_start : cold_starts(cell.workload())) warm += !cold_start;
    EXPECT_EQ(timing.either_queries, warm);
    EXPECT_EQ(timing.separated_queries + timing.overlapping_queries, 0U);
    EXPECT_FALSE(timing.separated());
    EXPECT_TRUE(timing.all());
}

}  // namespace
}  // namespace edgewise::bench
