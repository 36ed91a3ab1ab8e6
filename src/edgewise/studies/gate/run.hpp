// SPDX-License-Identifier: MIT
//
// The measurements of a guard on speed: a fixed set of small workloads, one scene on one body at a time, all
// its cells in interleaved rounds with the reference and the kernel. A cell's answers are checked before it
// is timed.
//
// Records of speed (measure/record/record.hpp): ratios of times measured in the same rounds of one process,
// and how a run is compared with a baseline. Of a thousand intervals of 95 % a few lie next to the truth:
// what seems slower is measured again, on new tables, and fails only if every measurement says so.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/record/comparison.hpp"

namespace edgewise::studies {

inline constexpr const char* speed_kind = "speed";

/// Figure of a cell's time over V-Clip's on the paper's record, for the same scene and shape.
inline constexpr const char* over_reference = "time over reference";
/// Figure of the reference's own time over that of work that no change of the algorithms touches.
inline constexpr const char* over_kernel = "time over kernel";

/// Returns the table type of a cell.
[[nodiscard]] std::string gate_table_of(const std::string& cell);

/// Returns the median of the times' ratios, round by round, with its interval. Null for fewer rounds than an
/// interval takes (measure::least_sample), or if a time is not positive.
[[nodiscard]] std::optional<measure::RecordRow> gate_row(std::string cell, std::string figure,
                                                         std::span<const double> times,
                                                         std::span<const double> beside);

/// Compares a run with the baseline's medians; the baseline's intervals decide nothing. A reference that
/// changed gets a note.
[[nodiscard]] measure::RecordComparison compare_speed(measure::FigureRecord baseline,
                                                      const measure::FigureRecord& now);

/// Returns the groups with a row that is worse, each once, in the comparison's order.
[[nodiscard]] std::vector<std::string> suspect_groups(const measure::RecordComparison& found);

/// Replaces rows that are worse in `found` by those of `again` if their interval begins lower; others stay,
/// so a second measurement can only clear a row.
void look_again(measure::FigureRecord& now, const measure::RecordComparison& found,
                const measure::FigureRecord& again);

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
