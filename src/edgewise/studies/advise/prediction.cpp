// SPDX-License-Identifier: MIT
#include "edgewise/studies/advise/prediction.hpp"

#include <algorithm>

namespace edgewise::studies::advise {

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
