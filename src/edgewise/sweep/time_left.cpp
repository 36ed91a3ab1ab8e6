// SPDX-License-Identifier: MIT
#include "edgewise/sweep/time_left.hpp"

#include <algorithm>
#include <cmath>

namespace edgewise::sweep {

namespace {

/// How far off the speed of a kind is that has not run yet, as a logarithm: work is counted by rules of
/// thumb, while an earlier run measured.
const double unmeasured = std::log(2.5), remembered = std::log(1.4);

}  // namespace

void TimeLeft::Speeds::add(double work, double seconds) {
    if (!(work > 0 && seconds > 0)) return;
    const double log = std::log(seconds / work);
    weight += work;
    sum += work * log;
    squares += work * log * log;
    weight_squares += work * work;
}

double TimeLeft::Speeds::deviation(double at_first) const {
    if (!(weight > 0)) return at_first;
    const double mean = sum / weight, variance = std::max(0.0, squares / weight - mean * mean);
    const double groups = weight * weight / weight_squares;  // of equal weight
    return std::sqrt((groups * variance + at_first * at_first) / (groups + 1));
}

void TimeLeft::done(const std::string& kind, double work, double seconds) {
    Kind& one = kinds_[kind];
    one.ahead -= work;
    one.work += work;
    one.seconds += seconds;
    one.group_work += work;
    one.group_seconds += seconds;
}

void TimeLeft::end_group() {
    for (auto& [name, kind] : kinds_) {
        kind.groups.add(kind.group_work, kind.group_seconds);
        kind.group_work = kind.group_seconds = 0;
    }
}

std::optional<double> TimeLeft::seconds() const {
    double work = 0, took = 0;
    for (const auto& [name, kind] : kinds_) {
        work += kind.work;
        took += kind.seconds;
    }
    double left = 0, variance = 0;
    for (const auto& [name, kind] : kinds_) {
        if (!(kind.ahead > 0)) continue;
        const bool known = name == last_run;
        // A kind that has not run yet is as much slower or faster here as all others together.
        const double speed = kind.work > 0          ? kind.seconds / kind.work
                             : known || !(work > 0) ? 1
                                                    : took / work;
        Speeds speeds = kind.groups;
        speeds.add(kind.group_work, kind.group_seconds);
        const double rest = kind.ahead * speed, deviation = speeds.deviation(known ? remembered : unmeasured);
        left += rest;
        variance += rest * rest * deviation * deviation;
    }
    if (!(left > 0) || std::sqrt(variance) / left > std::log(largest_factor)) return std::nullopt;
    return left;
}

}  // namespace edgewise::sweep
