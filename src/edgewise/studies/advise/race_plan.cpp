// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/race_plan.hpp"

#include <algorithm>

#include "edgewise/measure/counters/calibration.hpp"
#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::studies::advise {

double race_seconds(const RaceCost& cost, const RacePlan& plan) {
    return (plan.processes + 1) * (cost.process + plan.rounds * cost.round) + cost.traces;
}

RacePlan race_within(double seconds, const RaceCost& cost) {
    for (RacePlan plan = whole_race; plan.processes >= least_race.processes; --plan.processes) {
        for (plan.rounds = whole_race.rounds; plan.rounds >= least_race.rounds; --plan.rounds)
            if (race_seconds(cost, plan) <= seconds) return plan;
    }
    return least_race;
}

bool TimeLimit::begin_piece() {
    const double now = clock_();
    if (begun_) longest_ = std::max(longest_, now - *begun_);
    begun_ = now;
    return now + longest_ < end_;
}

namespace {

constexpr std::uint64_t line_bytes = 64, loads = 100000;
constexpr double memory_over_last = 4;  ///< times the last level: rarely answered by it
constexpr std::uint64_t most_bytes = 1 << 28;

/// Returns ns per load over this many bytes: the shortest of three passes after one that fills the caches.
double load_ns(std::uint64_t bytes) {
    measure::RandomChase chase(std::clamp(bytes, line_bytes, most_bytes));
    chase.run(2 * chase.lines());
    double shortest = 0;
    for (int pass = 0; pass < 3; ++pass) {
        const measure::Stopwatch watch;
        chase.run(loads);
        const double ns = watch.elapsed_ns() / static_cast<double>(loads);
        shortest = pass == 0 ? ns : std::min(shortest, ns);
    }
    return shortest;
}

}  // namespace

std::vector<double> latencies_beyond_first(const measure::CacheMachine& host) {
    std::vector<std::uint64_t> sizes;
    for (const measure::LevelGeometry& level : host.caches.levels)
        sizes.push_back(std::uint64_t{level.sets} * level.ways * host.caches.line_bytes);
    const double first = load_ns(sizes.front() / 2);
    std::vector<double> beyond;
    for (std::size_t i = 1; i < sizes.size(); ++i)
        beyond.push_back(std::max(0.0, load_ns(sizes[i] / 2) - first));
    beyond.push_back(std::max(
        0.0,
        load_ns(static_cast<std::uint64_t>(memory_over_last * static_cast<double>(sizes.back()))) - first));
    return beyond;
}

namespace {

/// Returns the time that the levels take to answer these misses, given level by level.
double waiting_ns(const std::vector<double>& misses, std::span<const double> latencies_ns) {
    double sum = 0;
    for (std::size_t level = 0; level < misses.size(); ++level) {
        const bool last = level + 1 == misses.size();
        const double deeper = last ? 0 : misses[level + 1];
        sum += (misses[level] - deeper) *
               (last ? latencies_ns.back() : latencies_ns[std::min(level, latencies_ns.size() - 1)]);
    }
    return sum;
}

}  // namespace

void predict(CacheCost& cost, std::span<const double> latencies_ns) {
    if (latencies_ns.empty() || !cost.in_cache_ns) return;
    for (const auto& [machine, misses] : cost.misses)
        cost.predicted_ns[machine] = *cost.in_cache_ns + waiting_ns(misses, latencies_ns);
}

}  // namespace edgewise::studies::advise
