// SPDX-License-Identifier: MIT
//
// What the processor's counters are asked for, by names that mean the same on every processor. Which event
// of which processor answers is in event_table.hpp.
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
    bool must_happen;  ///< in any work of many thousand loads over more memory than the first cache holds
};

/// In the order of reports. Four in a row are counted together, so ratios within such a row are of the same
/// run.
inline constexpr std::array<MetricName, 12> metrics{{
    {Metric::instructions, "instructions", true},
    {Metric::cycles, "cycles", true},
    {Metric::branches, "branches", true},
    {Metric::branch_misses, "branch_misses", false},
    {Metric::loads, "loads", true},
    {Metric::stores, "stores", true},
    {Metric::l1d_fills, "l1d_fills", true},
    {Metric::l1d_load_misses, "l1d_load_misses", true},
    {Metric::l2_demand_misses, "l2_demand_misses", false},
    {Metric::llc_misses, "llc_misses", false},
    {Metric::dtlb_walks, "dtlb_walks", false},
    {Metric::line_crossing_loads, "line_crossing_loads", false},
}};

}  // namespace edgewise::measure
