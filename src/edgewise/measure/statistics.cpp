// SPDX-License-Identifier: MIT
//
// Order statistics, bootstrap and least squares; see statistics.hpp for the definitions and their sources.
#include "edgewise/measure/statistics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "edgewise/geometry/split_mix.hpp"

namespace edgewise::measure {

namespace {

bool usable(std::span<const double> sample) {
    return !sample.empty() &&
           std::all_of(sample.begin(), sample.end(), [](double v) { return std::isfinite(v); });
}

std::vector<double> sorted(std::span<const double> sample) {
    std::vector<double> result(sample.begin(), sample.end());
    std::sort(result.begin(), result.end());
    return result;
}

/// Rounded once, so that mirrored samples have mirrored medians.
double middle_of(double a, double b) { return 0.5 * (a + b); }

double sorted_quantile(const std::vector<double>& ordered, double p) {
    const double position = p * static_cast<double>(ordered.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, ordered.size() - 1);
    const double part = position - static_cast<double>(below);
    if (part == 0.5) return middle_of(ordered[below], ordered[above]);
    // The product may round up past the upper neighbour by its last bit.
    return std::min(ordered[below] + part * (ordered[above] - ordered[below]), ordered[above]);
}

/// Below `bound`, which must be less than 2^32; the bias, bound / 2^32, is nothing for samples of rounds.
std::uint32_t random_below(std::uint32_t bound, std::uint64_t& state) {
    return static_cast<std::uint32_t>(((split_mix(state) >> 32) * bound) >> 32);
}

/// Median of one sample drawn with replacement. Ranks are drawn instead of values: equal values need no care.
double resampled_median(const std::vector<double>& ordered, std::uint64_t& random,
                        std::vector<std::uint32_t>& ranks) {
    const auto size = static_cast<std::uint32_t>(ordered.size());
    for (std::uint32_t& rank : ranks) rank = random_below(size, random);
    const auto middle = ranks.begin() + size / 2;
    std::nth_element(ranks.begin(), middle, ranks.end());
    const double upper = ordered[*middle];
    if (size % 2 == 1) return upper;
    const double lower = ordered[*std::max_element(ranks.begin(), middle)];
    return middle_of(lower, upper);
}

}  // namespace

std::optional<double> quantile(std::span<const double> sample, double p) {
    if (!usable(sample) || !(p >= 0 && p <= 1)) return std::nullopt;
    return sorted_quantile(sorted(sample), p);
}

std::optional<double> median(std::span<const double> sample) { return quantile(sample, 0.5); }

std::vector<double> paired_ratios(std::span<const double> values, std::span<const double> baselines) {
    assert(values.size() == baselines.size());
    std::vector<double> ratios(std::min(values.size(), baselines.size()));
    for (std::size_t i = 0; i < ratios.size(); ++i) {
        ratios[i] = baselines[i] > 0 ? values[i] / baselines[i] : std::numeric_limits<double>::quiet_NaN();
    }
    return ratios;
}

int least_sample(double confidence) {
    int size = 1;
    for (double missed = 1; 1 - missed < confidence && size < 64; missed /= 2) ++size;
    return size;
}

std::optional<Interval> bootstrap_median(std::span<const double> sample, const Bootstrap& options) {
    assert(options.confidence > 0 && options.confidence < 1 && options.resamples > 0);
    if (!usable(sample) || sample.size() < static_cast<std::size_t>(least_sample(options.confidence))) {
        return std::nullopt;
    }
    const std::vector<double> ordered = sorted(sample);
    std::uint64_t random = options.seed;
    std::vector<std::uint32_t> ranks(ordered.size());
    std::vector<double> medians(static_cast<std::size_t>(options.resamples));
    for (double& value : medians) value = resampled_median(ordered, random, ranks);
    std::sort(medians.begin(), medians.end());
    const double tail = (1 - options.confidence) / 2;
    return Interval{sorted_quantile(medians, tail), sorted_quantile(medians, 1 - tail)};
}

std::optional<Line> least_squares(std::span<const double> x, std::span<const double> y,
                                  std::span<const double> weights) {
    assert(x.size() == y.size() && (weights.empty() || weights.size() == x.size()));
    if (!usable(x) || !usable(y) || x.size() != y.size()) return std::nullopt;
    // Differences to the first point, not to the mean: they stay integers, and the determinant below, the sum
    // of (x_i - x_j)^2 over all pairs, is at least the sum of squares: it loses no more than a factor n.
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double weight = weights.empty() ? 1 : weights[i];
        const double dx = x[i] - x[0];
        const double dy = y[i] - y[0];
        n += weight;
        sx += weight * dx;
        sy += weight * dy;
        sxx += weight * dx * dx;
        sxy += weight * dx * dy;
    }
    const double determinant = n * sxx - sx * sx;
    if (!(determinant > 0)) return std::nullopt;
    const double slope = (n * sxy - sx * sy) / determinant;
    return Line{slope, y[0] - slope * x[0] + (sy - slope * sx) / n};
}

}  // namespace edgewise::measure
