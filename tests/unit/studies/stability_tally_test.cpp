// SPDX-License-Identifier: MIT
//
// Counts of a stability row, from synthetic answers.
#include "edgewise/studies/stability/stability.hpp"

#include <gtest/gtest.h>

#include <map>

#include "edgewise/bench/registry.hpp"
#include "edgewise/scene/rng.hpp"
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
    const auto type = bench::select_table_types(std::vector<std::string>{"aos_f64"}).front();
    const auto runner = type->make_runner("gjk");
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

}  // namespace
}  // namespace edgewise::studies
