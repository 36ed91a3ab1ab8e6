// SPDX-License-Identifier: MIT
//
// The band around contact, and who is judged wrong on either side of it.
#include "edgewise/truth/accuracy_band.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "exact_bodies.hpp"

namespace edgewise::truth {
namespace {

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

ExactDistance exactly(ExactVerdict verdict, double distance) {
    ExactDistance exact;
    exact.verdict = verdict;
    exact.distance = distance;
    return exact;
}

constexpr AccuracyBand band{10, 0.5};
constexpr JudgedAnswer contact{false, 0};

TEST(Judge, separated_pairs) {
    const ExactDistance far = exactly(ExactVerdict::separated, 2);
    const ExactDistance near = exactly(ExactVerdict::separated, 0.25);
    const Judgement good = judge({true, 1.5}, far, band);
    EXPECT_FALSE(good.verdict_wrong);
    EXPECT_FALSE(good.in_band);
    EXPECT_EQ(good.error, 0.5);
    EXPECT_EQ(good.error_over_scale, 0.05);
    EXPECT_TRUE(judge(contact, far, band).verdict_wrong);
    EXPECT_EQ(judge(contact, far, band).error, 2);
    EXPECT_FALSE(judge(contact, near, band).verdict_wrong);
    EXPECT_TRUE(judge(contact, near, band).in_band);
    EXPECT_TRUE(judge({true, 0.25}, near, band).in_band);
}

TEST(Judge, touching_pairs_count_as_contact) {
    const ExactDistance touching = exactly(ExactVerdict::touching, 0);
    EXPECT_FALSE(judge(contact, touching, band).verdict_wrong);
    EXPECT_TRUE(judge(contact, touching, band).in_band);
    EXPECT_FALSE(judge({true, 0.5}, touching, band).verdict_wrong);
    EXPECT_TRUE(judge({true, 0.75}, touching, band).verdict_wrong);
}

TEST(Judge, overlapping_pairs_with_and_without_depth) {
    const ExactDistance overlapping = exactly(ExactVerdict::overlapping, 0);
    EXPECT_FALSE(judge(contact, overlapping, band).verdict_wrong);
    EXPECT_FALSE(judge(contact, overlapping, band).in_band);
    EXPECT_FALSE(judge({true, 0.25}, overlapping, band).verdict_wrong);
    EXPECT_TRUE(judge({true, 0.25}, overlapping, band).in_band);
    EXPECT_TRUE(judge({true, 0.75}, overlapping, band).verdict_wrong);
    EXPECT_TRUE(judge({true, 0.25}, overlapping, band, 1.0).verdict_wrong);
    EXPECT_FALSE(judge({true, 0.25}, overlapping, band, 0.25).verdict_wrong);
    EXPECT_TRUE(judge(contact, overlapping, band, 0.25).in_band);
}

TEST(Judge, nan_is_wrong_everywhere) {
    const JudgedAnswer nan{true, std::numeric_limits<double>::quiet_NaN()};
    for (const ExactVerdict v :
         {ExactVerdict::separated, ExactVerdict::touching, ExactVerdict::overlapping}) {
        EXPECT_TRUE(judge(nan, exactly(v, 0), band).verdict_wrong);
    }
}

}  // namespace
}  // namespace edgewise::truth
