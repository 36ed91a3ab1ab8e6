// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/cold_caches.hpp"

#include <utility>

namespace edgewise::measure {

ColdCaches::ColdCaches(std::span<const CacheMachine> machines) {
    for (const CacheMachine& machine : machines) {
        const std::vector<std::uint64_t> none(machine.caches.levels.size());
        machines_.push_back({CacheModel(machine.caches), {none, none, none}, none, {}});
    }
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
        for (std::size_t i = 0; i < cold.booked.size(); ++i) {
            const std::uint64_t before = std::exchange(cold.booked[i], cold.model.counts(i).misses);
            cold.misses.each(start_, [&](auto& misses) { misses[i] += cold.booked[i] - before; });
        }
        for (const std::uint64_t line : cold.lines) cold.model.drop(line);
        cold.lines.clear();
    }
    start_.reset();
}

}  // namespace edgewise::measure
