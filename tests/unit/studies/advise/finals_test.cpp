// SPDX-License-Identifier: MIT
//
// What a race says, on made-up races: who is first, who ties, what the baseline differs by from itself, and a
// prediction that comes true or not. Sums were done by hand.
#include "edgewise/studies/advise/finals.hpp"

#include <gtest/gtest.h>

namespace edgewise::studies::advise {
namespace {

Finalist raced(const std::string& table, std::vector<double> ratios, double error = 1e-16) {
    Finalist one;
    one.algorithm = "vclip";
    one.table = table;
    for (const double ratio : ratios) one.ns.push_back(1000 * ratio);
    one.ratios = std::move(ratios);
    one.error = error;
    return one;
}

/// The baseline differs from itself by as much.
std::vector<Finalist> beside_baseline(double low, double high, std::vector<Finalist> others) {
    others.push_back(raced(baseline_table, {low, 1, high}));
    return others;
}

std::string tables_in_order(const Finals& finals) {
    std::string text;
    for (const Finalist& one : finals.ranked) text += one.table + " ";
    return text;
}

TEST(Finals, HasTheMedianOverProcessesAndItsTime) {
    const Finalist one = raced("lean_f64", {0.5, 0.7, 0.6});
    EXPECT_EQ(one.low(), 0.5);
    EXPECT_EQ(one.mid(), 0.6);
    EXPECT_EQ(one.high(), 0.7);
    EXPECT_EQ(one.mid_ns(), 600);
    EXPECT_EQ(one.name(), "V-Clip on lean_f64");
}

TEST(Finals, DividesByTheBaselinesMedian) {
    std::vector<Finalist> finalists = {raced("lean_f64", {0.88, 0.99, 1.1}),
                                       raced(baseline_table, {1.1, 1.0, 1.21}), raced("soa_f64", {})};
    const Finals finals = ranked_finals(finalists, 1e-6);
    EXPECT_EQ(tables_in_order(finals), "lean_f64 aos_f64 ") << "who was not timed is none";
    EXPECT_DOUBLE_EQ(finals.noise_low, 1 / 1.1);
    EXPECT_DOUBLE_EQ(finals.noise_high, 1.21 / 1.1);
    EXPECT_DOUBLE_EQ(finals.baseline()->mid(), 1);
    EXPECT_DOUBLE_EQ(finals.ranked.front().low(), 0.8);
    EXPECT_DOUBLE_EQ(finals.ranked.front().mid(), 0.9);
    EXPECT_EQ(finals.ranked.front().mid_ns(), 990) << "a time stays one";
}

TEST(Finals, NeverTakesWhoIsOverTheLimit) {
    const Finals finals = ranked_finals({raced("quantised_f64", {0.3}, 1e-5), raced("lean_f32", {0.6}, 1e-7),
                                         raced(baseline_table, {1}, 2e-7)},
                                        1e-7);
    EXPECT_EQ(tables_in_order(finals), "lean_f32 ");
    ASSERT_EQ(finals.over_limit.size(), 2U);
    ASSERT_NE(finals.baseline(), nullptr) << "compared with all the same";
    EXPECT_EQ(finals.baseline()->table, baseline_table);
}

TEST(Finals, TieWhereIntervalsMeetOrTheBaselineDiffersAsMuchFromItself) {
    const Finals finals = ranked_finals(
        beside_baseline(0.96, 1.05,
                        {raced("first", {0.50, 0.51, 0.52}), raced("meets", {0.515, 0.56, 0.6}),
                         raced("in_band", {0.525, 0.53, 0.535}), raced("beyond", {0.55, 0.56, 0.57})}),
        1e-6);
    EXPECT_TRUE(finals.ties(*finals.find("vclip", "first")));
    EXPECT_TRUE(finals.ties(*finals.find("vclip", "meets")));
    EXPECT_TRUE(finals.ties(*finals.find("vclip", "in_band"))) << "0.53 / 0.51 = 1.04 < 1.05";
    EXPECT_FALSE(finals.ties(*finals.find("vclip", "beyond"))) << "0.56 / 0.51 = 1.10 > 1.05";
    EXPECT_FALSE(finals.ties(*finals.baseline()));
}

TEST(Finals, BandIsThatOfTheLargerSide) {
    const std::vector<Finalist> two = {raced("first", {0.5}), raced("next", {0.54})};
    EXPECT_TRUE(ranked_finals(beside_baseline(0.9, 1.01, two), 1).ties(two[1])) << "1 / 0.9 = 1.11";
    EXPECT_FALSE(ranked_finals(beside_baseline(0.99, 1.01, two), 1).ties(two[1]));
}

Finalist with_misses(const std::string& table, double ratio, double in_cache_ns,
                     std::vector<double> host_misses) {
    Finalist one = raced(table, {ratio});
    one.in_cache_ns = in_cache_ns;
    one.misses[this_machine] = std::move(host_misses);
    return one;
}

TEST(Finals, PredictsTheWaitForEachLevel) {
    Finals finals = ranked_finals({with_misses("lean_f64", 0.5, 100, {10, 4})}, 1);
    finals.ranked[0].misses["one_level"] = {10};
    finals.ranked[0].misses["three_levels"] = {10, 4, 1};
    predict(finals, std::vector<double>{5, 80});  // the second level, memory
    const auto& predicted = finals.ranked[0].predicted_ns;
    EXPECT_DOUBLE_EQ(predicted.at(this_machine), 100 + 6 * 5 + 4 * 80);
    EXPECT_DOUBLE_EQ(predicted.at("one_level"), 100 + 10 * 80);
    EXPECT_DOUBLE_EQ(predicted.at("three_levels"), 100 + 6 * 5 + 3 * 80 + 1 * 80);
}

/// In cache `aos` is faster; its misses cost it more than `lean` loses there.
std::vector<Finalist> race_of(double lean_ratio, double aos_ratio) {
    return {with_misses("lean_f64", lean_ratio, 150, {2}), with_misses(baseline_table, aos_ratio, 100, {10})};
}

TEST(Finals, APredictionHoldsOrDoesNot) {
    const std::vector<double> memory = {50};  // 250 ns against 600 ns
    Finals held = ranked_finals(race_of(0.5, 1), 1), failed = ranked_finals(race_of(1.6, 1), 1),
           tied = ranked_finals(race_of(1.0, 1), 1), unknown = ranked_finals({raced("lean_f64", {0.5})}, 1);
    for (Finals* finals : {&held, &failed, &tied, &unknown}) predict(*finals, memory);
    EXPECT_EQ(held.fastest_predicted(this_machine)->table, "lean_f64");
    EXPECT_EQ(held.prediction_held(), true);
    EXPECT_EQ(failed.fastest_predicted(this_machine)->table, "lean_f64");
    EXPECT_EQ(failed.prediction_held(), false);
    EXPECT_EQ(tied.prediction_held(), true);
    EXPECT_EQ(unknown.fastest_predicted(this_machine), nullptr);
    EXPECT_EQ(unknown.prediction_held(), std::nullopt);
    EXPECT_EQ(held.fastest_predicted("another"), nullptr);
}

}  // namespace
}  // namespace edgewise::studies::advise
