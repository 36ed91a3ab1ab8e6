// SPDX-License-Identifier: MIT
//
// The look inside GJK: what must hold of its counts, in scenes where the answer is known.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/probes/cost.hpp"
#include "edgewise/probes/work.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "found.hpp"

namespace edgewise::probes {
namespace {

AlgorithmWork look(const char* scene, const char* shape, const scene::SceneParameters& parameters) {
    const studies::SingleCell cell({"aos_f64", "gjk", scene, shape, parameters, 2000, 1});
    std::vector<std::size_t> positions;
    for (std::size_t i = 0; i < 2000; i += 7) positions.push_back(i);
    return gjk_work(cell.type(), cell.workload(), positions);
}

void expect_sound(const AlgorithmWork& work) {
    EXPECT_GT(work.queries, 0U);
    EXPECT_LE(work.kept, work.near);
    EXPECT_LE(work.near, work.kept_of);
    EXPECT_EQ(work.accepted[0] + work.accepted[1] + work.accepted[2] + work.accepted[3], work.sub_distances);
    EXPECT_GE(work.subsets_tried, work.sub_distances);
    EXPECT_LE(work.subsets_tried, 15 * work.sub_distances);
    EXPECT_LE(work.same_features, work.compared);
}

TEST(Work, NothingMovesInAStillScene) {
    const AlgorithmWork work =
        look("tumble", "sphere386", {{"rotation_step", 0}, {"translation_step", 0}, {"steps", 1000}});
    expect_sound(work);
    EXPECT_GT(work.kept_of, 0U);
    EXPECT_EQ(work.kept, work.kept_of) << "the same simplex every time";
}

TEST(Work, ClimbsFartherFromAnywhere) {
    const AlgorithmWork coherent = look("tumble", "sphere386", {{"rotation_step", 0.01}});
    const AlgorithmWork cold = look("cold", "sphere386", {});
    const AlgorithmWork cold_large = look("cold", "sphere6146", {});
    expect_sound(coherent);
    expect_sound(cold);
    const auto hops = [](const AlgorithmWork& w) {
        return static_cast<double>(w.hops) / static_cast<double>(w.supports);
    };
    std::printf("hops of a climb: coherent %.2f, cold %.2f, cold at 16 times the vertices %.2f\n",
                hops(coherent), hops(cold), hops(cold_large));
    EXPECT_LT(hops(coherent), hops(cold));
    EXPECT_LT(hops(cold), hops(cold_large));
    EXPECT_EQ(cold.kept_of, 0U) << "nothing is kept between cold queries";
    EXPECT_GT(cold.compared, 0U);
}

TEST(Work, SaysWhyItDoesNotLook) {
    for (const auto& [table, algorithm] : {std::pair{"aos_f64", "vclip"}, std::pair{"lean_f32", "gjk"}}) {
        const studies::SingleCell cell({table, algorithm, "cold", "cube8", {}, 50, 1});
        const auto found = by_name(work::measure({.type = cell.type(),
                                                  .algorithm = bench::algorithm_called(algorithm),
                                                  .runner = cell.runner(),
                                                  .workload = cell.workload()})
                                       .figures);
        EXPECT_FALSE(found.at("support_unchanged").value) << table << " " << algorithm;
    }
}

TEST(Work, IsSharesOfWhatWasLookedAt) {
    bench::AnswerCounts counts;
    counts.warm = 800;
    counts.unchanged = 200;
    const auto not_looked = by_name(work::figures({}, counts));
    EXPECT_EQ(not_looked.at("unchanged").value, 0.25);
    EXPECT_FALSE(not_looked.at("told_by_bounds").value) << "nobody asked them";
    counts.told = 600;
    const auto of_nearness = by_name(work::figures({}, counts, Needs::nearer));
    EXPECT_EQ(of_nearness.at("told_by_bounds").value, 0.75);
    EXPECT_FALSE(of_nearness.at("unchanged").value) << "most start nowhere";
    const auto of_cold = by_name(work::figures({}, {}, Needs::nearer));
    EXPECT_FALSE(of_cold.at("told_by_bounds").value) << "none starts warm";
    EXPECT_FALSE(not_looked.at("support_unchanged").value);
    expect_values(
        work::figures({100, 50, 25, 400, 80, 60, 72, 200, 500, {20, 60, 100, 20}, 40, 30, "", ""}, counts),
        {{"support_unchanged", 0.75},
         {"support_near", 0.9},
         {"hops_per_support", 0.5},
         {"vertices_per_support", 8},
         {"subsets_tried", 2.5},
         {"accepted_3", 0.5},
         {"features_agree", 0.75}});
}

studies::SingleCell cell_of(const char* scene, const scene::SceneParameters& parameters,
                            std::size_t queries = 3000) {
    return studies::SingleCell({"aos_f64", "gjk", scene, "cube8", parameters, queries, 1});
}

TEST(StepCosts, CountWhatAStepAsks) {
    const studies::SingleCell cell =
        cell_of("tumble", {{"bodies", 50}, {"in_time_order", 1}, {"steps", 1000}});
    const StepCosts costs = step_costs(cell.runner(), cell.workload());
    ASSERT_GT(costs.steps, 10U);
    EXPECT_EQ(costs.bodies, 50);
    const auto& frames = cell.workload().frames;
    const std::size_t first = frames[1].first_query, last = frames[costs.steps + 1].first_query;
    EXPECT_DOUBLE_EQ(costs.pairs, static_cast<double>(last - first) / static_cast<double>(costs.steps));
    EXPECT_GE(costs.box_tests, costs.pairs) << "each near pair was tested";
    EXPECT_LT(costs.box_tests, 50 * 49 / 2.0) << "and not all pairs";
    EXPECT_GT(costs.step_ns, 0);
    const double equation_2 = costs.equation_1() + costs.bodies * costs.update_ns;
    EXPECT_NEAR(costs.equation_2(), equation_2, 1e-12 * equation_2);
    const double equation_1 = costs.box_tests * costs.box_test_ns + costs.pairs * costs.pair_ns;
    EXPECT_NEAR(costs.equation_1(), equation_1, 1e-12 * equation_1);
}

TEST(StepCosts, AreNotThereWithoutSteps) {
    const studies::SingleCell cold = cell_of("static", {});
    EXPECT_EQ(step_costs(cold.runner(), cold.workload()).steps, 0U);
    EXPECT_FALSE(step_costs(cold.runner(), cold.workload()).reason.empty());
    const studies::SingleCell one = cell_of("tumble", {{"in_time_order", 1}, {"steps", 1}}, 30);
    EXPECT_EQ(step_costs(one.runner(), one.workload()).steps, 0U) << "no step has one before it";
    EXPECT_FALSE(step_costs(one.runner(), one.workload()).remedy.empty());
}

TEST(StepCosts, AddUpToTheCostFunctions) {
    EXPECT_FALSE(by_name(cost::figures({})).at("step_ns").value);
    const auto cost = by_name(cost::figures({10, 100, 300, 50, 7, 20, 2, 400, 25000, "", ""}));
    EXPECT_EQ(cost.at("equation_1_ns").value, 300 * 2 + 50 * 400);
    EXPECT_EQ(cost.at("equation_2_ns").value, 300 * 2 + 50 * 400 + 100 * 20);
    EXPECT_EQ(cost.at("all_pairs").value, 4950);
    EXPECT_NEAR(*cost.at("equation_2_ratio").value, 22600.0 / 25000, 1e-12);
}

}  // namespace

}  // namespace edgewise::probes
