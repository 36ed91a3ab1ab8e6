// SPDX-License-Identifier: MIT
//
// The statistics of times; deterministic figures (bytes, modelled misses, steps) get none. Pure functions.
// Each answers null where its question has no answer: an empty sample, a value that is not finite.
//
// Quantiles interpolate linearly between order statistics (type 7 of Hyndman and Fan, "Sample Quantiles in
// Statistical Packages", 1996: what R and NumPy do by default). The interval of the median is the percentile
// bootstrap (Efron, 1979): no assumption about the distribution; good for the median, not for the tails.
// Its ends are order statistics, so that on small samples it covers the true median not quite as often as it
// says. At 0.95, for odd sizes, computed from the binomial distribution: 87.5 % at 7 observations, 96 % at 9,
// 93 % at 11, 91 % at 13, 95 % at 17, 92 to 96 % from 25 on. Take 9, 17 or at least 25 rounds.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace edgewise::measure {

/// The value below which the fraction p (0 to 1) of the sample lies; the sample needs no order.
[[nodiscard]] std::optional<double> quantile(std::span<const double> sample, double p);

[[nodiscard]] std::optional<double> median(std::span<const double> sample);

/// values[i] / baselines[i], both measured in the same round, so that what slowed one slowed the other. NaN
/// where the baseline is not positive: a pair that cannot be judged must not vanish from the sample. Sizes
/// must agree.
[[nodiscard]] std::vector<double> paired_ratios(std::span<const double> values,
                                                std::span<const double> baselines);

struct Interval {
    double lower, upper;
};

struct Bootstrap {
    double confidence = 0.95;
    int resamples = 2000;  ///< enough that the ends land on, or next to, their final order statistics
    std::uint64_t seed = 0x2001'0168;  ///< fixed: the same sample gives the same interval, to the bit
};

/// Observations needed before any interval of the median can have this confidence: even from the smallest to
/// the largest of n it has only 1 - 2^(1-n). 6 for 0.95.
[[nodiscard]] int least_sample(double confidence);

/// Null also when the sample is smaller than least_sample: a bootstrap of five values would look precise.
[[nodiscard]] std::optional<Interval> bootstrap_median(std::span<const double> sample,
                                                       const Bootstrap& options = {});

struct Line {
    double slope, intercept;
};

/// Least squares of y over x, each point with a positive weight; no weights: all are 1. Null for fewer than
/// two different x. Exact (no rounding) while every sum of products of the differences to the first point is
/// an integer below 2^53, as for bytes over edges.
[[nodiscard]] std::optional<Line> least_squares(std::span<const double> x, std::span<const double> y,
                                                std::span<const double> weights = {});

}  // namespace edgewise::measure
