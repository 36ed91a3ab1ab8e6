// SPDX-License-Identifier: MIT
//
// The measurements of a guard on speed: a fixed set of small workloads, one scene on one body at a time, all
// its cells in interleaved rounds with the reference and the kernel. A cell's answers are checked before it
// is timed.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/studies/gate/speed_record.hpp"

namespace edgewise::studies {

struct GatePlan {
    std::vector<const bench::TableType*> types;  ///< the reference's own need not be among them
    int rounds = 17;
    std::size_t queries = 1000;       ///< per pass
    std::vector<std::string> groups;  ///< only these, as gate_groups names them; empty: all
};

struct GateRun {
    measure::FigureRecord record;
    /// Cells with wrong answers, and the error of each. They have no row, except a reference.
    std::vector<std::string> wrong;
};

/// Returns every scene on every body: "cold cube8".
[[nodiscard]] std::vector<std::string> gate_groups();

/// Returns nothing if `stop` was set. Throws std::invalid_argument when the program lacks the reference's
/// table type, or if there are too few rounds or queries for a ratio.
[[nodiscard]] std::optional<GateRun> run_gate(const GatePlan& plan,
                                              const std::function<void(const std::string& group)>& on_group,
                                              const std::atomic<bool>& stop);

}  // namespace edgewise::studies
