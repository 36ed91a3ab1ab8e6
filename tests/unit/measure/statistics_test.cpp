// SPDX-License-Identifier: MIT
//
// Statistics against known values, against properties that hold for any sample, and the bootstrap against the
// binomial distribution that it approximates and against its promise: how often it covers the true median.
#include "edgewise/measure/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace edgewise::measure {
namespace {

using Sample = std::vector<double>;

/// Uniform in [0, 1): xorshift64*, another generator than the one under test.
class Uniform {
  public:
    explicit Uniform(std::uint64_t seed) : state_(seed * 2 + 1) {}
    double operator()() {
        state_ ^= state_ >> 12;
        state_ ^= state_ << 25;
        state_ ^= state_ >> 27;
        return static_cast<double>((state_ * 2685821657736338717u) >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_;
};

Sample skewed_sample(Uniform& uniform, std::size_t size) {
    Sample sample(size);
    for (double& value : sample) {
        const double u = uniform();
        value = u * u * u;  // a long tail to the right, as times have; true median 1/8
    }
    return sample;
}

TEST(Statistics, MedianOfSmallSamples) {
    EXPECT_EQ(median(Sample{3}), 3.0);
    EXPECT_EQ(median(Sample{4, 1}), 2.5);
    EXPECT_EQ(median(Sample{9, 1, 5}), 5.0);
    EXPECT_EQ(median(Sample{4, 1, 3, 2}), 2.5);
    EXPECT_EQ(median(Sample{-1, -1, 7, 7}), 3.0);
}

TEST(Statistics, QuantilesAreThoseOfTypeSeven) {
    // R: quantile(c(15, 20, 35, 40, 50), c(.05, .3, .4, .5, 1), type = 7)
    const Sample sample = {40, 15, 50, 20, 35};
    EXPECT_DOUBLE_EQ(*quantile(sample, 0.05), 16);
    EXPECT_DOUBLE_EQ(*quantile(sample, 0.3), 23);
    EXPECT_DOUBLE_EQ(*quantile(sample, 0.4), 29);
    EXPECT_EQ(quantile(sample, 0), 15.0);
    EXPECT_EQ(quantile(sample, 0.5), 35.0);
    EXPECT_EQ(quantile(sample, 1), 50.0);
    EXPECT_EQ(quantile(Sample{1, 2, 3, 4}, 0.25), 1.75);
    EXPECT_EQ(quantile(Sample{7}, 0.9), 7.0);
}

TEST(Statistics, WhatHasNoAnswerIsNull) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(median(Sample{}));
    EXPECT_FALSE(median(Sample{1, nan, 2}));
    EXPECT_FALSE(median(Sample{1, infinity}));
    EXPECT_FALSE(quantile(Sample{1, 2}, 1.5));
    EXPECT_FALSE(quantile(Sample{1, 2}, nan));
    EXPECT_FALSE(bootstrap_median(Sample{}));
    EXPECT_FALSE(bootstrap_median(Sample{1, 2, 3, 4, 5}));  // one too few
    EXPECT_TRUE(bootstrap_median(Sample{1, 2, 3, 4, 5, 6}));
    EXPECT_FALSE(bootstrap_median(Sample{1, 2, 3, 4, 5, nan}));
    EXPECT_FALSE(least_squares(Sample{}, Sample{}));
    EXPECT_FALSE(least_squares(Sample{1}, Sample{1}));
    EXPECT_FALSE(least_squares(Sample{2, 2, 2}, Sample{1, 2, 3}));
    EXPECT_FALSE(least_squares(Sample{1, 2}, Sample{1, nan}));
}

TEST(Statistics, LeastSampleIsWhereTheFullRangeReachesTheConfidence) {
    EXPECT_EQ(least_sample(0.5), 2);
    EXPECT_EQ(least_sample(0.9), 5);
    EXPECT_EQ(least_sample(0.95), 6);
    EXPECT_EQ(least_sample(0.99), 8);
}

TEST(Statistics, QuantilesOfRandomSamplesKeepTheirProperties) {
    Uniform uniform(1);
    for (std::size_t size = 1; size <= 60; ++size) {
        Sample sample = skewed_sample(uniform, size);
        const auto [low, high] = std::minmax_element(sample.begin(), sample.end());
        const double least = *low, most = *high, middle = *median(sample);
        double before = least;
        for (int i = 0; i <= 20; ++i) {
            const double q = *quantile(sample, i / 20.0);
            EXPECT_GE(q, before) << size;
            before = q;
        }
        EXPECT_EQ(before, most);
        const auto below = std::count_if(sample.begin(), sample.end(), [&](double v) { return v < middle; });
        const auto above = std::count_if(sample.begin(), sample.end(), [&](double v) { return v > middle; });
        EXPECT_LE(below * 2, static_cast<long>(size));
        EXPECT_LE(above * 2, static_cast<long>(size));

        std::reverse(sample.begin(), sample.end());
        EXPECT_EQ(median(sample), middle);
        for (double& value : sample) value *= -4;  // exact
        EXPECT_EQ(median(sample), -4 * middle);
    }
}

TEST(Statistics, PairedRatiosStayPaired) {
    const Sample ratios = paired_ratios(Sample{10, 9, 8, 7}, Sample{5, 3, 0, -1});
    ASSERT_EQ(ratios.size(), 4u);
    EXPECT_EQ(ratios[0], 2.0);
    EXPECT_EQ(ratios[1], 3.0);
    EXPECT_TRUE(std::isnan(ratios[2]));
    EXPECT_TRUE(std::isnan(ratios[3]));
    EXPECT_FALSE(median(ratios));  // so that a bad baseline shows and does not vanish
    EXPECT_TRUE(paired_ratios({}, {}).empty());
}

TEST(Statistics, PairedRatiosCancelWhatSlowsBoth) {
    Uniform uniform(2);
    Sample slow(101), fast(101);
    for (std::size_t i = 0; i < slow.size(); ++i) {
        const double disturbance = 1 + 9 * uniform();
        fast[i] = 100 * disturbance;
        slow[i] = 150 * disturbance;
    }
    for (const double ratio : paired_ratios(slow, fast)) EXPECT_NEAR(ratio, 1.5, 1e-15);
}

TEST(Statistics, BootstrapIsTheSameToTheBit) {
    Sample sample(31);
    for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = static_cast<double>(i * i % 37);
    const Interval first = *bootstrap_median(sample);
    const Interval again = *bootstrap_median(sample);
    EXPECT_EQ(first.lower, again.lower);
    EXPECT_EQ(first.upper, again.upper);
    std::reverse(sample.begin(), sample.end());
    EXPECT_EQ(first.lower, bootstrap_median(sample)->lower);  // the order of the rounds is no information

    // The generator and its use are part of the definition: these ranks must not change with the compiler.
    Sample ranks(100);
    for (std::size_t i = 0; i < ranks.size(); ++i) ranks[i] = static_cast<double>(i);
    const Interval pinned = *bootstrap_median(ranks, {.confidence = 0.5, .resamples = 101, .seed = 7});
    EXPECT_EQ(pinned.lower, 45.5);
    EXPECT_EQ(pinned.upper, 52.5);
    const Interval other = *bootstrap_median(ranks, {.confidence = 0.5, .resamples = 101, .seed = 8});
    EXPECT_TRUE(other.lower != pinned.lower || other.upper != pinned.upper);
}

TEST(Statistics, BootstrapHoldsTheMedianAndFollowsTheScale) {
    Uniform uniform(3);
    for (std::size_t size = 6; size <= 40; ++size) {
        Sample sample = skewed_sample(uniform, size);
        const Interval interval = *bootstrap_median(sample);
        const double middle = *median(sample);
        EXPECT_LE(interval.lower, middle);
        EXPECT_GE(interval.upper, middle);
        EXPECT_LT(interval.lower, interval.upper);
        const Interval narrower = *bootstrap_median(sample, {.confidence = 0.5});
        EXPECT_GE(narrower.lower, interval.lower);
        EXPECT_LE(narrower.upper, interval.upper);
        for (double& value : sample) value *= 8;  // exact
        EXPECT_EQ(bootstrap_median(sample)->lower, 8 * interval.lower);
        EXPECT_EQ(bootstrap_median(sample)->upper, 8 * interval.upper);
    }
    const Interval constant = *bootstrap_median(Sample(9, 5.0));
    EXPECT_EQ(constant.lower, 5);
    EXPECT_EQ(constant.upper, 5);
}

/// P(the median of a resample <= the k-th of n, k from 1), n odd: at least (n+1)/2 of n draws are among the
/// first k.
double resampled_at_most(int n, int k) {
    const double p = static_cast<double>(k) / n;
    double sum = 0;
    for (int hits = (n + 1) / 2; hits <= n; ++hits) {
        const double log_ways = std::lgamma(n + 1.0) - std::lgamma(hits + 1.0) - std::lgamma(n - hits + 1.0);
        const double misses = n - hits;
        if (p == 1 && misses > 0) continue;
        sum += std::exp(log_ways + hits * std::log(p) + (misses > 0 ? misses * std::log(1 - p) : 0));
    }
    return sum;
}

TEST(Statistics, BootstrapEndsAreThoseOfTheBinomialDistribution) {
    double worst = 0;
    for (const int n : {7, 11, 25, 51, 101}) {
        Sample ranks(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i) ranks[static_cast<std::size_t>(i)] = i + 1;
        const Interval interval = *bootstrap_median(ranks, {.resamples = 20'000});
        // With 20000 resamples a tail of 0.025 has a standard error of 0.0011; four of them.
        const double noise = 4 * std::sqrt(0.025 * 0.975 / 20'000);
        const int lower = static_cast<int>(interval.lower), upper = static_cast<int>(interval.upper);
        EXPECT_GE(resampled_at_most(n, lower), 0.025 - noise) << n;
        EXPECT_LE(resampled_at_most(n, lower - 1), 0.025 + noise) << n;
        EXPECT_GE(resampled_at_most(n, upper), 0.975 - noise) << n;
        EXPECT_LE(resampled_at_most(n, upper - 1), 0.975 + noise) << n;
        worst = std::max(worst, std::abs(lower + upper - (n + 1.0)));
    }
    std::printf("largest asymmetry of the ends: %g ranks\n", worst);
    EXPECT_LE(worst, 1);
}

TEST(Statistics, BootstrapCoversTheTrueMedianAsOftenAsItSays) {
    constexpr int trials = 600;
    for (const std::size_t size : {std::size_t{9}, std::size_t{17}, std::size_t{30}, std::size_t{61}}) {
        Uniform uniform(1000 + size);
        int covered = 0;
        for (int trial = 0; trial < trials; ++trial) {
            const Interval interval = *bootstrap_median(skewed_sample(uniform, size), {.resamples = 1000});
            covered += interval.lower <= 0.125 && 0.125 <= interval.upper;
        }
        const double share = static_cast<double>(covered) / trials;
        std::printf("%zu observations: the 95 %% interval covers the true median in %.1f %% of %d trials\n",
                    size, 100 * share, trials);
        EXPECT_GE(share, 0.90);
        EXPECT_LE(share, 0.99);
    }
}

TEST(Statistics, LeastSquaresIsExactOnIntegers) {
    // Bytes of tables of real sizes: 168 a further edge, with a constant part.
    const Sample edges = {12, 108, 1152, 4800, 19'494, 1'000'002};
    Sample bytes(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) bytes[i] = 168 * edges[i] + 16;
    const Line line = *least_squares(edges, bytes);
    EXPECT_EQ(line.slope, 168);
    EXPECT_EQ(line.intercept, 16);
    const Line twice = *least_squares(Sample{1, 2, 4}, Sample{3, 3, 7}, Sample{2, 1, 1});
    const Line listed = *least_squares(Sample{1, 1, 2, 4}, Sample{3, 3, 3, 7});
    EXPECT_EQ(twice.slope, listed.slope);
    EXPECT_EQ(twice.intercept, listed.intercept);
    const Line reversed = *least_squares(Sample{4, 2}, Sample{10, 4});
    EXPECT_EQ(reversed.slope, 3);
    EXPECT_EQ(reversed.intercept, -2);
    // Anscombe's first set: slope 0.5, intercept 3, to the three digits that are published.
    const Line anscombe =
        *least_squares(Sample{10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5},
                       Sample{8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68});
    EXPECT_NEAR(anscombe.slope, 0.500, 0.0005);
    EXPECT_NEAR(anscombe.intercept, 3.00, 0.005);
}

TEST(Statistics, LeastSquaresLeavesResidualsThatNoLineExplains) {
    Uniform uniform(4);
    double worst = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Sample x(20), y(20);
        const double far = trial % 2 == 0 ? 0 : 1e6;  // the origin far away costs no digits
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = far + uniform();
            y[i] = uniform() - 0.5;
        }
        const Line line = *least_squares(x, y);
        double sum = 0, moment = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double residual = y[i] - (line.intercept + line.slope * x[i]);
            sum += residual;
            moment += residual * (x[i] - far);
        }
        worst = std::max({worst, std::abs(sum), std::abs(moment)});
    }
    std::printf("worst sum or moment of the residuals: %.2g\n", worst);
    EXPECT_LE(worst, 20 * 8 * 1e6 * 0x1p-52);  // 20 points, slopes up to 8 or so, |x| up to 1e6
}

}  // namespace
}  // namespace edgewise::measure
