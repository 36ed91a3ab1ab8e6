// SPDX-License-Identifier: MIT
//
// The band around contact.
#include "edgewise/truth/accuracy_band.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
