// SPDX-License-Identifier: MIT
//
// Relative residuals, since the largest body's value would outweigh all others'.
#include "edgewise/reports/paper/claims/claim_cells.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace edgewise::reports {

namespace {

constexpr std::size_t fewest_points = 3;

/// Null when all can be fitted.
std::optional<Evidence> unfit(const std::vector<CurvePoint>& curve) {
    for (const CurvePoint& point : curve) {
        if (!point.y.value) return point.y;
        if (!(point.x > 0) || !(point.y.low > 0)) return no_evidence("a value of 0 has no logarithm");
    }
    if (curve.size() < fewest_points || curve.front().x == curve.back().x)
        return no_evidence(
            fmt::format("{} sizes are stored, a growth needs {}", curve.size(), fewest_points));
    return std::nullopt;
}

struct Line {
    double at_zero = 0, slope = 0;
};

/// y over t, each point with a weight.
Line weighted_line(const std::vector<double>& t, const std::vector<double>& y, const std::vector<double>& w) {
    double sw = 0, st = 0, sy = 0, stt = 0, sty = 0;
    for (std::size_t i = 0; i < t.size(); ++i) {
        sw += w[i];
        st += w[i] * t[i];
        sy += w[i] * y[i];
        stt += w[i] * t[i] * t[i];
        sty += w[i] * t[i] * y[i];
    }
    const double slope = (sw * sty - st * sy) / (sw * stt - st * st);
    return {(sy - slope * st) / sw, slope};
}

double root_mean_square(const std::vector<double>& all) {
    double squares = 0;
    for (const double one : all) squares += one * one;
    return std::sqrt(squares / static_cast<double>(all.size()));
}

}  // namespace

Evidence growth_exponent(const std::vector<CurvePoint>& curve) {
    if (const auto why = unfit(curve)) return *why;
    double middle = 0, squares = 0;
    for (const CurvePoint& point : curve) middle += std::log(point.x) / static_cast<double>(curve.size());
    for (const CurvePoint& point : curve) squares += std::pow(std::log(point.x) - middle, 2);
    double slope = 0, low = 0, high = 0;
    for (const CurvePoint& point : curve) {
        const double weight = (std::log(point.x) - middle) / squares;
        slope += weight * std::log(*point.y.value);
        low += weight * std::log(weight > 0 ? point.y.low : point.y.high);
        high += weight * std::log(weight > 0 ? point.y.high : point.y.low);
    }
    // A curve without intervals has none either; sums in another order would differ in their last bit.
    const auto timed = [](const CurvePoint& point) { return point.y.has_interval(); };
    if (std::ranges::none_of(curve, timed)) return exact_evidence(slope);
    return interval_evidence(slope, low, high);
}

LogOrPower log_or_power(const std::vector<CurvePoint>& curve) {
    if (const auto why = unfit(curve)) return {*why, *why};
    std::vector<double> t, y, log_y, relative, equal;
    for (const CurvePoint& point : curve) {
        t.push_back(std::log(point.x));
        y.push_back(*point.y.value);
        log_y.push_back(std::log(y.back()));
        relative.push_back(1 / (y.back() * y.back()));
        equal.push_back(1);
    }
    const Line logarithm = weighted_line(t, y, relative), power = weighted_line(t, log_y, equal);
    std::vector<double> of_logarithm, of_power;
    for (std::size_t i = 0; i < t.size(); ++i) {
        of_logarithm.push_back((logarithm.at_zero + logarithm.slope * t[i]) / y[i] - 1);
        of_power.push_back(std::exp(power.at_zero + power.slope * t[i]) / y[i] - 1);
    }
    return {exact_evidence(root_mean_square(of_logarithm)), exact_evidence(root_mean_square(of_power))};
}

}  // namespace edgewise::reports
