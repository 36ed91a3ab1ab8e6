// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/cold_caches.hpp"

namespace edgewise::measure {

ColdCaches::ColdCaches(std::span<const CacheMachine> machines) {
    for (const CacheMachine& machine : machines) machines_.push_back({CacheModel(machine.caches), {}});
}

void ColdCaches::on_access(const TracedAccess& access) {
    if (access.side == TraceSide::scene) return;
    for (Cold& cold : machines_) {
        if (cold.model.access(access.address, access.bytes, access.kind) == 0) continue;
        access.for_each_unit(cold.model.geometry().line_bytes,
                             [&](std::uint64_t line) { cold.lines.push_back(line); });
    }
}

void ColdCaches::on_query_end(bool /*counts*/) {
    for (Cold& cold : machines_) {
        for (const std::uint64_t line : cold.lines) cold.model.drop(line);
        cold.lines.clear();
    }
}

std::vector<std::uint64_t> ColdCaches::misses(std::size_t machine) const {
    std::vector<std::uint64_t> all;
    for (const LevelCounts& level : machines_[machine].model.counts()) all.push_back(level.misses);
    return all;
}

}  // namespace edgewise::measure
