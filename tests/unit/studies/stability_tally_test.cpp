// SPDX-License-Identifier: MIT
//
// Counts of a stability row, from synthetic answers.
#include "edgewise/studies/stability/stability.hpp"

#include <gmock/gmock.h>

#include <map>

#include "../temporary_folder.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::studies {
namespace {

std::map<std::string, std::optional<double>> figures_of(const StabilityTally& tally) {
    std::map<std::string, std::optional<double>> result;
    for (const measure::Figure& figure : tally.figures()) result[figure.name] = figure.value;
    return result;
}

TEST(StabilityTally, SumsWhatTheAnswersCounted) {
    StabilityTally tally;
    StabilityAnswer asked;
    asked.answer.status = Status::separated;
    asked.answer.escapes = 2;
    asked.answer.refinements = 1;
    tally.add(asked);
    asked.answer.escapes = 3;
    asked.answer.cycles = asked.answer.fallbacks = 1;
    tally.add(asked);
    auto found = figures_of(tally);
    EXPECT_EQ(found["cases"], 2);
    EXPECT_EQ(found["escapes"], 5);
    EXPECT_EQ(found["refinements"], 2);
    EXPECT_EQ(found["cycles"], 1);
    EXPECT_EQ(found["fallbacks"], 1);
}

TEST(StabilityTally, AWrongDistanceIsAWrongAnswerAndIsCountedOnce) {
    StabilityTally tally;
    StabilityAnswer asked;
    asked.answer.status = Status::separated;
    tally.add(asked);  // right
    asked.checked.distance_wrong = true;
    tally.add(asked);
    asked.checked.verdict_wrong = true;
    tally.add(asked);
    asked.checked.distance_wrong = false;
    tally.add(asked);
    auto found = figures_of(tally);
    EXPECT_EQ(found["errors_beyond"], 2);
    EXPECT_EQ(found["wrong_outside_band"], 2);
    EXPECT_EQ(found["wrong_answers"], 3);
}

TEST(StabilityTally, SaysWhyThereIsNoTime) {
    StabilityTally tally;
    tally.add_time("0", std::nullopt, "not asked for");
    for (const measure::Figure& figure : tally.figures()) {
        if (figure.name == "ns_at_0") {
            EXPECT_EQ(figure.reason, "not asked for");
        }
    }
    EXPECT_TRUE(figures_of(tally).contains("ns_at_0"));
}

TEST(StabilityTally, CountsCapHitsApartFromWrongDepths) {
    StabilityTally tally;
    StabilityProof proof;
    tally.add(proof);
    proof.depth_cut_short = true;
    tally.add(proof);
    proof.depth_wrong = true;
    tally.add(proof);
    auto found = figures_of(tally);
    EXPECT_EQ(found["certificates"], 3);
    EXPECT_EQ(found["cap_hits"], 2);
    EXPECT_EQ(found["depths_beyond"], 1);
}

/// Concentric spheres are about equally deep all round: EPA wants more faces than its limit.
TEST(StabilityTally, ARunnerSaysThatADepthWasCutShort) {
    const auto runner = bench::table_type_called("aos_f64").make_runner("gjk");
    scene::Rng rng(1);
    for (const char* name : {"cube8", "sphere9602"}) {
        const Polyhedron body = *scene::make_shape(name);
        ASSERT_EQ(runner->load(std::vector{body, body}), "");
        const bench::NamedAnswer answer =
            runner->answer(scene::Query{0, 1, 0, {}, {rng.rotation(), Vec3d::Zero()}});
        EXPECT_EQ(answer.distance.status, Status::overlapping) << name;
        EXPECT_EQ(answer.depth_cut_short, body.vertex_count() > 8) << name;
        EXPECT_GT(answer.depth, 1) << name;
        EXPECT_LT(answer.depth, 2.1) << name;
    }
}

// Raw V-Clip: where hardened V-Clip did not ask GJK, both answers are the same to the last bit. Their steps
// may differ: hardened V-Clip starts cold queries nearer, and after contact the two may be at different
// features. Where hardened V-Clip asked GJK, raw V-Clip still ends; in hard families raw V-Clip is wrong.

const bench::TableType& raw_table() { return bench::table_type_called(raw_type); }

std::vector<Distance> answers_of(const scene::Workload& workload, bool hardened) {
    const auto runner = raw_table().make_runner("vclip");
    runner->configure({.query = {.hardened = hardened}});
    EXPECT_EQ(runner->load(workload), "");
    return runner->answer();
}

TEST(RawVClip, IsTheHardenedOneWhereThatAsksNobody) {
    std::size_t alike = 0;
    for (const char* shape : {"cube8", "sphere386"}) {
        const auto workload = scene::make_scene("tumble", scene::make_shape(shape).or_throw(),
                                                {{"rotation_step", 0.3}}, 1, 4000, {})
                                  .or_throw();
        const auto hard = answers_of(workload, true), raw = answers_of(workload, false);
        bool same_start = true;  // an answer of GJK's leaves other features to start from
        for (std::size_t i = 0; i < hard.size(); ++i) {
            EXPECT_EQ(raw[i].fallbacks + raw[i].refinements, 0);
            const bool by_itself = hard[i].fallbacks + hard[i].refinements == 0;
            same_start = same_start && by_itself;
            if (!same_start) continue;
            ++alike;
            EXPECT_EQ(raw[i].status, hard[i].status) << shape << " " << i;
            EXPECT_EQ(raw[i].distance, hard[i].distance) << shape << " " << i;
        }
    }
    EXPECT_GT(alike, 1000U);
}

TEST(RawVClip, IsWrongOnHardFamiliesWhereTheHardenedOneIsRight) {
    StabilityPlan plan;
    plan.count = 30;
    plan.proofs = 0;
    plan.types = {&raw_table()};
    plan.algorithms = {"vclip"};
    plan.raw = true;
    std::map<std::string, double> wrong;
    std::size_t judged = 0, rows = 0;
    const std::atomic<bool> go_on = false;
    const TemporaryFolder folder;
    store::Store store(folder / "s.db");
    const bool done = run_stability(
        plan, store,
        [&](const store::StoredCell& row) {
            const bool raw = row.axes == "hardening=off";
            EXPECT_TRUE(raw || row.status != store::CellStatus::judged);
            EXPECT_FALSE(row.failed());
            ++rows;
            judged += row.status == store::CellStatus::judged;
            for (const store::FigureRow& figure : row.figures)
                if (figure.name == "wrong_outside_band" || figure.name == "errors_beyond")
                    wrong[raw ? "raw" : "hardened"] += figure.value.value_or(0);
        },
        go_on);
    EXPECT_TRUE(done);
    EXPECT_EQ(rows, stability_rows(plan));
    EXPECT_GT(judged, 0U);
    EXPECT_GT(wrong["raw"], 0);
    EXPECT_EQ(wrong["hardened"], 0);
}

}  // namespace
}  // namespace edgewise::studies
