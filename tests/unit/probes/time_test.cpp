// SPDX-License-Identifier: MIT
//
// Medians, intervals and ratios from known rounds.
#include "edgewise/probes/time.hpp"

#include <gtest/gtest.h>

#include "found.hpp"

namespace edgewise::probes {
namespace {

measure::Round round_of(int number, double ns, double baseline_ns) {
    return {number, {10, 5, 10 * ns, 5 * 2 * ns}, {10, 5, 10 * baseline_ns, 5 * 2 * baseline_ns}};
}

std::vector<measure::Round> nine_rounds() {
    std::vector<measure::Round> rounds;
    for (int i = 0; i < 9; ++i) rounds.push_back(round_of(i, 100 + i, 200 + 2 * i));
    return rounds;
}

TEST(Time, IsMediansAndRatiosOfTheSameRound) {
    const std::vector<measure::Round> rounds = nine_rounds();
    auto found = by_name(time::figures(rounds, true));
    EXPECT_EQ(found["separated_ns"].value, 104);
    EXPECT_EQ(found["overlapping_ns"].value, 208);
    EXPECT_EQ(found["separated_ratio"].value, 0.5);
    EXPECT_LT(found["separated_ns_low"].value, 104);
    EXPECT_GT(found["separated_ns_high"].value, 104);
    EXPECT_EQ(found["rounds"].value, 9);
    EXPECT_FALSE(by_name(time::figures({}, true))["separated_ns"].value);
    const auto few = by_name(time::figures(std::span(rounds).first(2), true));
    EXPECT_TRUE(few.at("separated_ns").value);
    EXPECT_FALSE(few.at("separated_ns_low").value);
}

TEST(Time, OfAllPairsIsTheBothTogether) {
    const auto time = by_name(time::figures(nine_rounds(), true));
    // 10 separated at 104 ns and 5 overlapping at twice that, a median round of the nine.
    EXPECT_NEAR(*time.at("all_ns").value, (10 * 104.0 + 5 * 208.0) / 15, 1e-9);
    EXPECT_LE(*time.at("all_ns_low").value, *time.at("all_ns").value);
    EXPECT_GE(*time.at("all_ns_high").value, *time.at("all_ns").value);
    EXPECT_NEAR(*time.at("all_ratio").value, 0.5, 1e-9);
}

/// Of followed pairs 5 first queries beside 15 others; of the rest every query starts cold.
TEST(Time, OfFirstQueriesStandsApartByName) {
    std::vector<measure::Round> rounds = nine_rounds();
    for (measure::Round& round : rounds) {
        round.timing.first_queries = 5;
        round.timing.first_ns = 5 * 1000;
    }
    const double steady = (10 * 104.0 + 5 * 208.0) / 15;
    const auto time = by_name(time::figures(rounds, true));
    EXPECT_EQ(time.at("query_ns.cold").value, 1000);
    EXPECT_NEAR(*time.at("query_ns.warm").value, steady, 1e-9);
    EXPECT_NEAR(*time.at("query_ns").value, (15 * steady + 5 * 1000) / 20, 1e-9);
    EXPECT_NEAR(*time.at("all_ns").value, steady, 1e-9) << "first queries are none of it";
    const auto cold = by_name(time::figures(nine_rounds(), false));
    EXPECT_NEAR(*cold.at("query_ns.cold").value, steady, 1e-9);
    EXPECT_NEAR(*cold.at("query_ns").value, steady, 1e-9);
    EXPECT_FALSE(cold.at("query_ns.warm").value);
    EXPECT_EQ(cold.at("query_ns.warm").reason, "no query here starts warm");
}

TEST(Time, OfPairsOfEitherKindIsOfAllAlone) {
    std::vector<measure::Round> rounds = nine_rounds();
    for (measure::Round& round : rounds) {
        round.timing = {};
        round.timing.either_queries = 20;
        round.timing.either_ns = 20.0 * (100 + round.number);
    }
    const auto time = by_name(time::figures(rounds, true));
    EXPECT_EQ(time.at("all_ns").value, 104);
    EXPECT_TRUE(time.at("all_ratio").value);
    EXPECT_FALSE(time.at("separated_ns").value);
    EXPECT_EQ(time.at("separated_ns").reason, "what was asked does not tell this kind of pair");
    EXPECT_FALSE(time.at("overlapping_ratio").value);
}

}  // namespace
}  // namespace edgewise::probes
