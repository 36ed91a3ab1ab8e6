// SPDX-License-Identifier: MIT
#include "edgewise/studies/thrash/query_time.hpp"

#include <algorithm>

namespace edgewise::studies::thrash {

namespace {

/// An LRU memory smaller than what is swept over once a step misses every unit of the sweep, one as large
/// misses none.
double swept_misses(double units, double memory_units) { return units > memory_units ? units : 0; }

/// Returns the misses of a step's queries after a sweep: the memory holds the sweep's last units, so this
/// part of the step's distinct units misses on average.
double misses_after_sweep(double distinct, double units, double memory_units) {
    return distinct * std::max(0.0, 1 - memory_units / units);
}

double page_faults(const TimedScene& scene, std::uint64_t memory_bytes) {
    return misses_at(scene.sizes->pages, scene.demand->page_misses, memory_bytes / page_bytes);
}

/// Every table's plane, vertex and direction turned in every step, then the queries on what that left.
double transform_ns(const TimedScene& scene, const Setting& setting) {
    const MemoryDemand& demand = *scene.demand;
    const OldMachine& machine = *scene.machine;
    const double lines = demand.tables * demand.table_bytes / line_bytes,
                 pages = demand.tables * demand.table_bytes / page_bytes;
    const double steps_per_query = static_cast<double>(demand.steps) / static_cast<double>(demand.queries);
    const auto first = static_cast<double>(machine.lines(0)), second = static_cast<double>(machine.lines(1)),
               tlb = static_cast<double>(machine.tlb_pages()),
               memory = static_cast<double>(setting.memory_bytes / page_bytes);
    const double sweep = lines * machine.ns_of_cycles(cycles_per_turned_line) +
                         machine.memory_time_ns(swept_misses(lines, first), swept_misses(lines, second),
                                                swept_misses(pages, tlb)) +
                         swept_misses(pages, memory) * setting.fault_ns;
    const double second_misses = misses_at(scene.sizes->lines, demand.line_misses, machine.lines(1));
    const double more_lines =
        std::max(0.0, misses_after_sweep(demand.lines_of_a_step, lines, second) - second_misses);
    const double more_faults = std::max(0.0, misses_after_sweep(demand.pages_of_a_step, pages, memory) -
                                                 page_faults(scene, setting.memory_bytes));
    return sweep * steps_per_query + more_lines * (machine.memory_ns() - machine.second_level_ns()) +
           more_faults * setting.fault_ns;
}

double mechanism_ns(const TimedScene& scene, const Setting& setting) {
    const MemoryDemand& demand = *scene.demand;
    switch (setting.mechanism) {
        case Mechanism::queries_alone:
            return 0;
        case Mechanism::whole_table_transform:
            return scene.is_vclip ? transform_ns(scene, setting) : 0;
        case Mechanism::builds:
            return setting.intensity * scene.build_reads * scene.ns_per_read;
        case Mechanism::builds_of_vclip:
            return scene.is_vclip ? setting.intensity * scene.build_reads * scene.ns_per_read : 0;
        case Mechanism::capped_cycles:
            return scene.is_vclip && scene.is_large
                       ? setting.intensity * reads_per_feature_step * scene.ns_per_read
                       : 0;
        case Mechanism::first_touches:
            return demand.pages / papers_iterations * setting.fault_ns;
    }
    return 0;
}

}  // namespace

double query_ns(const TimedScene& scene, const Setting& setting) {
    return scene.demand->reads * scene.ns_per_read + cache_ns(*scene.machine, *scene.sizes, *scene.demand) +
           page_faults(scene, setting.memory_bytes) * setting.fault_ns + mechanism_ns(scene, setting);
}

}  // namespace edgewise::studies::thrash
