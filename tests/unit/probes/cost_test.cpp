// SPDX-License-Identifier: MIT
//
// Costs of steps: what is counted is counted right, whatever the times are; scenes without steps say so.
#include "edgewise/probes/cost.hpp"

#include <gtest/gtest.h>

#include "edgewise/studies/single_cell.hpp"
#include "found.hpp"

namespace edgewise::probes {
namespace {

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
