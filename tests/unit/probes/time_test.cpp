// SPDX-License-Identifier: MIT
//
// Medians, intervals and ratios from known rounds.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/bench/scales/scale_study.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/probes/scale.hpp"
#include "edgewise/probes/time.hpp"
#include "edgewise/scene/shapes.hpp"
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

TEST(Time, IsTheCellsOwnWhereTheBaselineHasNoSuchPair) {
    std::vector<measure::Round> rounds = nine_rounds();
    for (measure::Round& round : rounds) round.baseline.overlapping_queries = 0;
    auto found = by_name(time::figures(rounds, true));
    EXPECT_EQ(found["overlapping_ns"].value, 208);
    EXPECT_FALSE(found["overlapping_ratio"].value);
    EXPECT_EQ(found["overlapping_ratio"].reason, "the baseline has no such query");
}

TEST(Time, OfAllPairsIsTheBothTogether) {
    const auto time = by_name(time::figures(nine_rounds(), true));
    // 10 separated at 104 ns and 5 overlapping at twice that, a median round of the nine.
    EXPECT_NEAR(*time.at("all_ns").value, (10 * 104.0 + 5 * 208.0) / 15, 1e-9);
    EXPECT_LE(*time.at("all_ns_low").value, *time.at("all_ns").value);
    EXPECT_GE(*time.at("all_ns_high").value, *time.at("all_ns").value);
    EXPECT_NEAR(*time.at("all_ratio").value, 0.5, 1e-9);
}

/// If pairs are followed, 5 first queries and 15 others; if not, every query starts cold.
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
    EXPECT_EQ(time.at("separated_ns").reason, "the queries asked for do not distinguish this kind of pair");
    EXPECT_FALSE(time.at("overlapping_ratio").value);
}

TEST(Scale, IsMediansAndTheRatioIsOfPairs) {
    bench::ScaleTimes times;
    times.shared_ns = {100, 300, 200, 210, 205, 206, 207};
    times.own_ns = {200, 300, 400, 420, 410, 412, 414};
    times.build_ns = {3, 1, 2};
    auto found = by_name(scale::figures(times));
    EXPECT_EQ(found["shared_query_ns"].value, 206);
    EXPECT_EQ(found["shared_over_own"].value, 0.5) << "of 0.5, 1, 0.5 and so on";
    EXPECT_EQ(found["shared_over_own_low"].value, 0.5);
    EXPECT_EQ(found["build_ns"].value, 2);
    EXPECT_FALSE(found["refit_ns"].value);
}

template <class Table>
bench::ScaleTimes study_of(const char* shape) {
    const Polyhedron body = stored_body<Table>(scene::make_shape(shape).or_throw()).or_throw();
    const bench::ScaleTimes times = bench::ScaleStudy<Table>(body).run(2);
    std::printf("%s of %s: %zu queries, %zu of other bits, worst error %.2g of %zu checked\n",
                std::string(Table::name).c_str(), shape, times.queries, times.other_bits, times.error,
                times.checked);
    return times;
}

TEST(Scale, OneTableAnswersAsATableEachAndExactly) {
    const bench::ScaleTimes in_double = study_of<lean<f64>>("sphere102"),
                            in_single = study_of<lean<f32>>("sphere102");
    for (const bench::ScaleTimes* times : {&in_double, &in_single}) {
        EXPECT_EQ(times->queries, 1536U);
        EXPECT_EQ(times->other_bits, 0U);
        EXPECT_GE(times->checked, 128U);
        EXPECT_LT(times->shared_bytes * 20, times->own_bytes);
    }
    EXPECT_LT(in_double.error, verified_error_double);
    EXPECT_LT(in_single.error, verified_error_single);
}

}  // namespace

}  // namespace edgewise::probes
