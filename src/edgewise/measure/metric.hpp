// SPDX-License-Identifier: MIT
//
// Metrics counted by the processor, by names that mean the same on every processor. The event of each
// processor that answers a metric is in event_table.hpp.
#pragma once

#include <array>
#include <string_view>

namespace edgewise::measure {

enum class Metric {
    instructions,
    cycles,
    branches,
    branch_misses,
    loads,
    stores,
    l1d_fills,
    l1d_load_misses,
    l2_demand_misses,
    llc_misses,
    dtlb_walks,
    line_crossing_loads
};

struct MetricName {
    Metric metric;
    std::string_view name;
    std::string_view level;  ///< of the caches, where it is about them: "core", "L1D", "L2", "LLC" ...
    bool must_happen;  ///< in any work of many thousand loads over more memory than the first cache holds
};

/// In the order of reports. Four in a row are counted together, so ratios within such a row are of the same
/// run.
inline constexpr std::array<MetricName, 12> metrics{{
    {Metric::instructions, "instructions", "core", true},
    {Metric::cycles, "cycles", "core", true},
    {Metric::branches, "branches", "core", true},
    {Metric::branch_misses, "branch_misses", "core", false},
    {Metric::loads, "loads", "core", true},
    {Metric::stores, "stores", "core", true},
    {Metric::l1d_fills, "l1d_fills", "L1D", true},
    {Metric::l1d_load_misses, "l1d_load_misses", "L1D", true},
    {Metric::l2_demand_misses, "l2_demand_misses", "L2", false},
    {Metric::llc_misses, "llc_misses", "LLC", false},
    {Metric::dtlb_walks, "dtlb_walks", "dTLB, page walks", false},
    {Metric::line_crossing_loads, "line_crossing_loads", "L1D", false},
}};

}  // namespace edgewise::measure
