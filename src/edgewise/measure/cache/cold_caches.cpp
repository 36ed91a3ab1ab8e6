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
        const std::uint64_t line_bytes = cold.model.geometry().line_bytes;
        const std::uint64_t last = (access.address + access.bytes - 1) / line_bytes;
        for (std::uint64_t line = access.address / line_bytes; line <= last; ++line)
            cold.lines.push_back(line);
    }
}

void ColdCaches::on_query_end(bool /*counts*/) {
    ++queries_;
    for (Cold& cold : machines_) {
        for (const std::uint64_t line : cold.lines) cold.model.drop(line);
        cold.lines.clear();
    }
}

std::vector<std::uint64_t> ColdCaches::misses(std::size_t machine) const {
    std::vector<std::uint64_t> all;
    const CacheModel& model = machines_[machine].model;
    for (std::size_t level = 0; level < model.levels(); ++level) all.push_back(model.counts(level).misses);
    return all;
}

}  // namespace edgewise::measure
