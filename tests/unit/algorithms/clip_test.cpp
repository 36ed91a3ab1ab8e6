// SPDX-License-Identifier: MIT
//
// Edge clipping compared with exact rational arithmetic: plane distances are small whole numbers, so that a
// place along the edge is a fraction, and two of them compare by cross-multiplication. A quotient of doubles
// is correctly rounded, so the fraction's double is what the clip must hold.
#include "edgewise/algorithms/vclip/clip.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "edgewise/scene/rng.hpp"

namespace edgewise {
namespace {

using vclip::Clip;
using vclip::Clipped;

struct Fraction {
    long numerator, denominator;  ///< denominator > 0
    [[nodiscard]] bool operator<(const Fraction& o) const {
        return numerator * o.denominator < o.numerator * denominator;
    }
    [[nodiscard]] double value() const {
        return static_cast<double>(numerator) / static_cast<double>(denominator);
    }
};

/// Zero of the linear function that has these values at 0 and 1.
Fraction root(long tail, long head) {
    return tail > head ? Fraction{tail, tail - head} : Fraction{-tail, head - tail};
}

/// The part of [0, 1] on which no plane is negative, and the planes that bound it.
struct Exact {
    Fraction low{0, 1}, high{1, 1};
    int at_low = -1, at_high = -1;

    Clipped against(long tail, long head, int plane) {
        if (tail < 0 && head < 0) return Clipped::simply_excluded;
        if (tail < 0 && low < root(tail, head)) {
            low = root(tail, head);
            at_low = plane;
        }
        if (head < 0 && root(tail, head) < high) {
            high = root(tail, head);
            at_high = plane;
        }
        return high < low ? Clipped::compoundly_excluded : Clipped::inside;
    }
};

TEST(Clip, KeepsExactlyWhatNoPlaneCutsOff) {
    scene::Rng rng(1);
    int count[3] = {}, full = 0, both_ends = 0, single_points = 0;
    for (int round = 0; round < 100000; ++round) {
        Clip<double, int> clip;
        Exact exact;
        Clipped last = Clipped::inside;
        for (int plane = 0; plane < 6 && last == Clipped::inside; ++plane) {
            const long tail = static_cast<long>(rng.below(40)) - 9;
            const long head = static_cast<long>(rng.below(40)) - 9;
            last = clip.against(static_cast<double>(tail), static_cast<double>(head), plane);
            ASSERT_EQ(last, exact.against(tail, head, plane));
            ASSERT_EQ(clip.low, exact.low.value());
            ASSERT_EQ(clip.high, exact.high.value());
            ASSERT_EQ(clip.at_low.value_or(-1), exact.at_low);
            ASSERT_EQ(clip.at_high.value_or(-1), exact.at_high);
        }
        ++count[static_cast<int>(last)];
        full += last == Clipped::inside && !clip.at_low && !clip.at_high;
        both_ends += last == Clipped::inside && clip.at_low && clip.at_high;
        single_points += last == Clipped::inside && clip.low == clip.high;
    }
    EXPECT_GT(count[static_cast<int>(Clipped::inside)], 1000);
    EXPECT_GT(count[static_cast<int>(Clipped::simply_excluded)], 1000);
    EXPECT_GT(count[static_cast<int>(Clipped::compoundly_excluded)], 1000);
    EXPECT_GT(full, 1000);
    EXPECT_GT(both_ends, 1000);
    EXPECT_GT(single_points, 10);
}

}  // namespace
}  // namespace edgewise
