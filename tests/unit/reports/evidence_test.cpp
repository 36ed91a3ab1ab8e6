// SPDX-License-Identifier: MIT
//
// Numbers with intervals, and how quantities grow.
#include "edgewise/reports/paper/claims/claim_rules.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {
namespace {

TEST(Evidence, QuotientsTakeTheWorstOfBoth) {
    const Evidence ratio = quotient(interval_evidence(10, 8, 12), interval_evidence(2, 1, 4));
    EXPECT_EQ(ratio.value, 5);
    EXPECT_EQ(ratio.low, 2);
    EXPECT_EQ(ratio.high, 12);
}

TEST(Evidence, MissingStaysMissingWithItsReason) {
    const Evidence none = no_evidence("why"), one = exact_evidence(1);
    for (const Evidence& result :
         {quotient(none, one), quotient(one, none), sum(one, none), geometric_mean({one, none}),
          smallest({none, one}), largest({one, none}), no_less_than(none, 1)}) {
        EXPECT_FALSE(result.value);
        EXPECT_EQ(result.missing, "why");
    }
}

TEST(Evidence, OfNothingIsMissing) {
    for (const Evidence& result : {geometric_mean({}), smallest({}), largest({})}) {
        EXPECT_FALSE(result.value);
        EXPECT_NE(result.missing, "");
    }
}

TEST(Evidence, ByZeroIsMissingNotInfinite) {
    EXPECT_FALSE(quotient(exact_evidence(1), exact_evidence(0)).value);
    EXPECT_FALSE(quotient(exact_evidence(1), interval_evidence(1, 0, 2)).value);
    EXPECT_FALSE(geometric_mean({exact_evidence(0), exact_evidence(1)}).value);
    EXPECT_EQ(quotient(exact_evidence(0), exact_evidence(1)).value, 0);
}

TEST(Evidence, MeansAndExtremesKeepIntervals) {
    const std::vector<Evidence> all = {interval_evidence(2, 1, 3), interval_evidence(8, 4, 16)};
    EXPECT_DOUBLE_EQ(*geometric_mean(all).value, 4);
    EXPECT_DOUBLE_EQ(geometric_mean(all).low, 2);
    EXPECT_DOUBLE_EQ(geometric_mean(all).high, std::sqrt(48.0));
    EXPECT_EQ(smallest(all).high, 3);
    EXPECT_EQ(largest(all).low, 4);
}

TEST(Evidence, TextHasIntervalAndUnit) {
    EXPECT_EQ(evidence_text(exact_evidence(168), "B/edge"), "168 B/edge");
    EXPECT_EQ(evidence_text(interval_evidence(0.93, 0.91, 0.95), "1"), "0.930 [0.910, 0.950]");
    EXPECT_EQ(evidence_text(no_evidence("why"), "1"), "not measured");
}

std::vector<CurvePoint> power_curve(double exponent, double error) {
    std::vector<CurvePoint> curve;
    for (const double x : {10., 100., 1000.}) {
        const double y = 7 * std::pow(x, exponent);
        curve.push_back({x, interval_evidence(y, y * (1 - error), y * (1 + error))});
    }
    return curve;
}

TEST(Growth, ExponentOfAPowerLaw) {
    EXPECT_NEAR(*growth_exponent(power_curve(0.7, 0)).value, 0.7, 1e-12);
    EXPECT_FALSE(growth_exponent(power_curve(0.7, 0)).has_interval());
}

/// The ends decide the slope: (log 1.1 - log 0.9) over log 100.
TEST(Growth, IntervalIsWhatTheValuesCanMakeOfIt) {
    const Evidence exponent = growth_exponent(power_curve(1, 0.1));
    EXPECT_NEAR(exponent.high - 1, std::log(1.1 / 0.9) / std::log(100.0), 1e-12);
    EXPECT_NEAR(1 - exponent.low, std::log(1.1 / 0.9) / std::log(100.0), 1e-12);
}

TEST(Growth, NeedsThreePointsAboveZero) {
    std::vector<CurvePoint> curve = power_curve(1, 0);
    curve[1].y = exact_evidence(0);
    EXPECT_FALSE(growth_exponent(curve).value);
    curve.pop_back();
    curve[1].y = exact_evidence(1);
    EXPECT_FALSE(growth_exponent(curve).value);
    EXPECT_FALSE(growth_exponent({}).value);
    EXPECT_FALSE(log_or_power({}).power.value);
}

TEST(Growth, TellsALogarithmFromAPower) {
    std::vector<CurvePoint> logarithm;
    for (const double x : {8., 38., 386., 6146.})
        logarithm.push_back({x, exact_evidence(1 + 2 * std::log(x))});
    EXPECT_LT(*log_or_power(logarithm).logarithm.value, 1e-12);
    EXPECT_GT(*log_or_power(logarithm).power.value, 0.05);
    EXPECT_LT(*log_or_power(power_curve(0.5, 0)).power.value, 1e-12);
    EXPECT_GT(*log_or_power(power_curve(0.5, 0)).logarithm.value, 0.05);
}

}  // namespace
}  // namespace edgewise::reports
