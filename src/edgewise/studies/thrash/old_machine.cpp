// SPDX-License-Identifier: MIT
#include "edgewise/studies/thrash/old_machine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace edgewise::studies::thrash {

OldMachine::OldMachine(const measure::CacheMachine& machine) : machine_(&machine) {
    if (machine.caches.line_bytes != line_bytes || machine.caches.levels.size() != 2 ||
        machine.tlbs.levels.empty() || !machine.latencies_known())
        throw std::invalid_argument(
            fmt::format("machine '{}': wants lines of {} bytes, two cache levels and a TLB with latencies",
                        machine.name, line_bytes));
}

std::uint64_t OldMachine::lines(std::size_t level) const {
    return machine_->caches.bytes_of(level) / line_bytes;
}

std::uint64_t OldMachine::tlb_pages() const { return machine_->tlbs.bytes_of(0) / page_bytes; }

double OldMachine::second_level_ns() const {
    return ns_of_cycles(machine_->origins[1].latency_cycles - machine_->origins[0].latency_cycles);
}

double OldMachine::memory_ns() const {
    return ns_of_cycles(machine_->memory.latency_cycles - machine_->origins[0].latency_cycles);
}

std::vector<OldMachine> old_machines() {
    std::vector<OldMachine> machines;
    for (const char* name : {"pentium2_deschutes", "pentium3_katmai", "pentium3_coppermine"}) {
        for (const measure::CacheMachine& machine : measure::cache_machines())
            if (machine.name == name) machines.emplace_back(machine);
    }
    return machines;
}

MemorySizes sizes_for(const std::vector<OldMachine>& machines, const std::vector<std::uint64_t>& memories) {
    MemorySizes sizes;
    for (const OldMachine& machine : machines) {
        sizes.lines.insert(sizes.lines.end(), {machine.lines(0), machine.lines(1)});
        sizes.pages.push_back(machine.tlb_pages());
    }
    for (const std::uint64_t bytes : memories) sizes.pages.push_back(bytes / page_bytes);
    for (std::vector<std::uint64_t>* list : {&sizes.lines, &sizes.pages}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
    return sizes;
}

double misses_at(const std::vector<std::uint64_t>& sizes, const std::vector<double>& misses,
                 std::uint64_t size) {
    const auto found = std::lower_bound(sizes.begin(), sizes.end(), size);
    assert(found != sizes.end() && *found == size);
    return misses[static_cast<std::size_t>(found - sizes.begin())];
}

double cache_ns(const OldMachine& machine, const MemorySizes& sizes, const MemoryDemand& demand) {
    return machine.memory_time_ns(misses_at(sizes.lines, demand.line_misses, machine.lines(0)),
                                  misses_at(sizes.lines, demand.line_misses, machine.lines(1)),
                                  misses_at(sizes.pages, demand.page_misses, machine.tlb_pages()));
}

double ns_per_read(const std::vector<CalibrationPoint>& points) {
    const auto excess = [&](double k) {
        double sum = 0;
        for (const CalibrationPoint& point : points) sum += std::log(point.model_ns(k) / point.top_ns);
        return sum;
    };
    if (points.empty() || excess(0) >= 0) return 0;
    double low = 0, high = 1;
    while (excess(high) < 0) high *= 2;
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (excess(middle) < 0 ? low : high) = middle;
    }
    return high;
}

}  // namespace edgewise::studies::thrash
