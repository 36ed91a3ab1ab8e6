// SPDX-License-Identifier: MIT
//
// Which answers are wrong, on either side of the band around contact and of the errors allowed.
#include "edgewise/truth/checked_answer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "edgewise/truth/accuracy_band.hpp"
#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr AccuracyBand wide{10, 0.5};
constexpr Claim contact{};

Claim apart(double distance) { return {.separated = true, .distance = distance}; }

/// With answers that are made up: the bodies are not looked at.
CheckedAnswer checked(const Claim& claim, ExactVerdict verdict, double distance,
                      std::optional<double> depth = {}, const Leeway& leeway = {}) {
    ExactDistance exact;
    exact.verdict = verdict;
    exact.distance = distance;
    KnownPair known(exact, depth);
    const Pose pose;
    return check(claim, {{}, pose, {}, pose}, known, wide, {0.01, 0.1}, leeway);
}

TEST(CheckedAnswer, separated_pairs) {
    const CheckedAnswer good = checked(apart(1.5), ExactVerdict::separated, 2);
    EXPECT_FALSE(good.wrong());
    EXPECT_FALSE(good.in_band);
    EXPECT_EQ(good.error, 0.5);
    EXPECT_EQ(good.worst_beyond(), 0);
    EXPECT_TRUE(checked(apart(1.3), ExactVerdict::separated, 2).distance_wrong);
    EXPECT_TRUE(checked(contact, ExactVerdict::separated, 2).verdict_wrong);
    EXPECT_EQ(checked(contact, ExactVerdict::separated, 2).error, 2);
    EXPECT_FALSE(checked(contact, ExactVerdict::separated, 0.25).verdict_wrong);
    EXPECT_TRUE(checked(contact, ExactVerdict::separated, 0.25).in_band);
    EXPECT_TRUE(checked(apart(0.25), ExactVerdict::separated, 0.25).in_band);
}

TEST(CheckedAnswer, touching_pairs_count_as_contact) {
    EXPECT_FALSE(checked(contact, ExactVerdict::touching, 0).verdict_wrong);
    EXPECT_TRUE(checked(contact, ExactVerdict::touching, 0).in_band);
    EXPECT_FALSE(checked(apart(0.5), ExactVerdict::touching, 0).verdict_wrong);
    EXPECT_TRUE(checked(apart(0.75), ExactVerdict::touching, 0).verdict_wrong);
}

TEST(CheckedAnswer, overlapping_pairs_are_excused_by_their_depth) {
    EXPECT_FALSE(checked(contact, ExactVerdict::overlapping, 0).verdict_wrong);
    EXPECT_FALSE(checked(contact, ExactVerdict::overlapping, 0).in_band) << "nobody asked how deep";
    EXPECT_TRUE(checked(apart(0.25), ExactVerdict::overlapping, 0, 1.0).verdict_wrong);
    EXPECT_FALSE(checked(apart(0.25), ExactVerdict::overlapping, 0, 0.25).verdict_wrong);
    EXPECT_TRUE(checked(apart(0.75), ExactVerdict::overlapping, 0, 0.25).verdict_wrong);
    const auto deep = [](double depth) {
        return checked({.depth = depth}, ExactVerdict::overlapping, 0, 3.0).depth_wrong;
    };
    EXPECT_FALSE(deep(4.4));
    EXPECT_TRUE(deep(4.6));
    EXPECT_TRUE(deep(nan));
}

TEST(CheckedAnswer, nan_and_no_answer_are_wrong_everywhere) {
    for (const auto& [verdict, distance] : {std::pair{ExactVerdict::separated, 2.0},
                                            {ExactVerdict::touching, 0.0},
                                            {ExactVerdict::overlapping, 0.0}}) {
        EXPECT_TRUE(checked(apart(nan), verdict, distance, 0.25).verdict_wrong);
        EXPECT_TRUE(checked({.failed = true}, verdict, distance).verdict_wrong);
    }
    Claim witnesses = apart(2);
    witnesses.witness_error = nan;
    EXPECT_TRUE(checked(witnesses, ExactVerdict::separated, 2).wrong());
}

TEST(CheckedAnswer, a_verdict_alone_has_no_distance_to_check) {
    Claim claim = apart(50);
    claim.verdict_only = true;
    EXPECT_FALSE(checked(claim, ExactVerdict::separated, 2).wrong());
    EXPECT_TRUE(checked(claim, ExactVerdict::overlapping, 0, 3.0).wrong());
}

/// Bodies 2 apart: within a tolerance of 5, and 3 deep in it.
TEST(CheckedAnswer, a_contact_tolerance_moves_the_verdict_and_its_band) {
    const auto within = [](const Claim& claim, double tolerance) {
        return checked(claim, ExactVerdict::separated, 2, {}, {tolerance, 0});
    };
    EXPECT_FALSE(within(contact, 5).wrong());
    EXPECT_FALSE(within(contact, 5).in_band);
    EXPECT_EQ(within(contact, 5).exact, ExactVerdict::touching);
    EXPECT_TRUE(within(apart(5.25), 5).verdict_wrong);
    EXPECT_FALSE(within(apart(2.25), 2.1).verdict_wrong) << "at the tolerance to within the band";
    EXPECT_FALSE(within(apart(2), 1).wrong());
    EXPECT_TRUE(within(contact, 1).verdict_wrong);
}

TEST(CheckedAnswer, a_margin_is_judged_on_either_side) {
    ExactDistance exact;
    exact.distance = 2;
    const auto wrong = [&](bool nearer, double margin, double gap_tolerance = 0) {
        return check_nearness(nearer, exact, margin, wide, gap_tolerance).wrong();
    };
    EXPECT_FALSE(wrong(true, 3));
    EXPECT_TRUE(wrong(false, 3));
    EXPECT_FALSE(wrong(false, 3, 0.5)) << "a gap tolerance makes distances longer";
    EXPECT_TRUE(wrong(true, 1));
    EXPECT_FALSE(wrong(true, 1.75) || wrong(false, 2.25)) << "either is right in the band";
}

TEST(AllowedErrors, are_those_of_what_computes_and_of_rounded_planes) {
    constexpr double in_double = Tolerance<double>::eps, in_single = Tolerance<float>::eps;
    EXPECT_EQ(allowed_errors(in_double).distance, verified_error_double);
    EXPECT_EQ(allowed_errors(in_single).distance, verified_error_single);
    EXPECT_EQ(allowed_errors(in_double, true).distance, verified_error_single);
    EXPECT_EQ(allowed_errors(in_double, true).depth, verified_depth_error_double);
    EXPECT_EQ(allowed_errors(in_single).depth, verified_error_single);
}

// The band around contact.

constexpr double eps = std::numeric_limits<double>::epsilon();
const Points small_box = box({0, 0, 0}, {2, 3, 6});  // diagonal 7, farthest corner 7 away

TEST(AccuracyBand, scale_is_extent_or_offset_whichever_is_larger) {
    const AccuracyBand near = accuracy_band(small_box, {}, small_box, moved({0, 3, 4}), eps);
    EXPECT_EQ(near.scale, 7);
    EXPECT_EQ(near.band, 16 * eps * 7);
    EXPECT_EQ(accuracy_band(small_box, {}, small_box, moved({0, 30, 40}), eps).scale, 50);
    const Pose far = moved({1e12, 0, 0});
    EXPECT_EQ(accuracy_band(small_box, far, small_box, far, eps).scale, 7);
    const Points off_centre = {{300, 0, 0}, {301, 0, 0}, {300, 400, 0}};
    EXPECT_EQ(accuracy_band(off_centre, {}, small_box, {}, eps).scale, 500);
}

TEST(AccuracyBand, widens_with_the_worse_rotation) {
    Pose stretched;
    stretched.rotation(0, 0) = 1.5;  // R^T R is off by 1.25
    const double expected = 16 * eps * 7 + 4 * 1.25 * 7;
    EXPECT_EQ(accuracy_band(small_box, stretched, small_box, {}, eps).band, expected);
    EXPECT_EQ(accuracy_band(small_box, {}, small_box, stretched, eps).band, expected);
}

TEST(AccuracyBand, excuses_its_width_of_an_error) {
    constexpr AccuracyBand band{10, 0.5};
    EXPECT_EQ(band.over_scale(5), 0.5);
    EXPECT_EQ(band.beyond(0.5), 0);
    EXPECT_EQ(band.beyond(5.5), 0.5);
    EXPECT_TRUE(std::isnan(band.beyond(std::numeric_limits<double>::quiet_NaN())));
    EXPECT_EQ((AccuracyBand{0, 0}.over_scale(0)), 0);
}

}  // namespace
}  // namespace edgewise::truth
