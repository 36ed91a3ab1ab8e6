// SPDX-License-Identifier: MIT
//
// The worst of known errors, their quantiles, and counts of verdicts.
#include "edgewise/probes/error.hpp"

#include <gtest/gtest.h>

#include "found.hpp"

namespace edgewise::probes {
namespace {

std::vector<truth::CheckedAnswer> ten_answers() {
    std::vector<truth::CheckedAnswer> checked;
    for (int i = 0; i < 10; ++i) {
        truth::CheckedAnswer answer;
        answer.exact = i < 7    ? truth::ExactVerdict::separated
                       : i == 7 ? truth::ExactVerdict::touching
                                : truth::ExactVerdict::overlapping;
        answer.band.scale = 2;
        answer.error = i * 1e-15;
        answer.error_given = i * 1e-8;
        answer.witness_error = i * 1e-16;
        checked.push_back(answer);
    }
    checked[9].verdict_wrong = true;
    checked[8].distance_wrong = true;
    checked[4].in_band = true;
    return checked;
}

TEST(Error, IsTheWorstAndVerdictsAreCounted) {
    const auto checked = ten_answers();
    expect_values(error::figures(checked, {1000, 1500, 3, 2, 17, 5, 8}),
                  {{"checked", 10},
                   {"worst_error_stored", checked[9].error / 2},
                   {"worst_error_given", checked[9].error_given / 2},
                   {"wrong_verdicts", 1},
                   {"wrong_answers", 2},
                   {"verdicts_in_band", 1},
                   {"separated", 7},
                   {"touching", 1},
                   {"overlapping", 2},
                   {"fallbacks", 3},
                   {"cycles", 2},
                   {"refinements", 5},
                   {"escapes", 8},
                   {"mean_steps", 1.5},
                   {"max_steps", 17}});
}

TEST(Error, OfTheControlIsCountedOrSaidNotToBeAsked) {
    auto checked = ten_answers();
    EXPECT_FALSE(by_name(error::figures(checked, {})).at("control_disagreements").value);
    checked[4].control_disagrees = true;  // in the band
    checked[5].control_disagrees = true;
    checked[6].control_disagrees = false;
    expect_values(
        error::figures(checked, {}),
        {{"control_checked", 3}, {"control_disagreements", 2}, {"control_disagreements_outside_band", 1}});
}

/// Errors 1 to `count`, in no order: 17 has no divisor in common with the counts that are asked for.
std::vector<truth::CheckedAnswer> ranked_answers(std::size_t count) {
    std::vector<truth::CheckedAnswer> checked(count);
    for (std::size_t i = 0; i < count; ++i) {
        checked[i].band.scale = 1;
        checked[i].error_given = static_cast<double>(1 + i * 17 % count);
        checked[i].error = 1e9;
    }
    return checked;
}

TEST(Error, HasQuantilesOfTheGivenBodiesWhereThereAreEnoughAnswers) {
    // By hand: 0.5 x 1000 and 0.999 x 1000 steps above the least of 1001.
    const auto of_1001 = by_name(error::figures(ranked_answers(1001), {}));
    EXPECT_EQ(of_1001.at("p50_error_given").value, 501);
    EXPECT_DOUBLE_EQ(of_1001.at("p999_error_given").value.value_or(0), 1000);
    EXPECT_EQ(of_1001.at("worst_error_given").value, 1001);

    const auto of_1000 = by_name(error::figures(ranked_answers(1000), {}));
    const double p999 = of_1000.at("p999_error_given").value.value_or(0);
    EXPECT_TRUE(p999 > 998 && p999 < 1000) << p999 << ": it differs from the worst";

    const measure::Figure of_999 = by_name(error::figures(ranked_answers(999), {})).at("p999_error_given");
    EXPECT_FALSE(of_999.value);
    EXPECT_NE(of_999.reason.find("999 checked answers"), std::string::npos) << of_999.reason;
    EXPECT_NE(of_999.remedy.find("1000"), std::string::npos) << of_999.remedy;
}

TEST(Error, OfNoAnswerIsNoNumber) {
    EXPECT_FALSE(by_name(error::figures({}, {}))["worst_error_stored"].value);
}

}  // namespace
}  // namespace edgewise::probes
