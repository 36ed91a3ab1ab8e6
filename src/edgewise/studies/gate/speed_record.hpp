// SPDX-License-Identifier: MIT
//
// Records of speed (measure/record/record.hpp): ratios of times measured in the same rounds of one process,
// and how a run is compared with a baseline. Of a thousand intervals of 95 % a few lie next to the truth:
// what seems slower is measured again, on new tables, and fails only if every measurement says so.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "edgewise/measure/record/comparison.hpp"

namespace edgewise::studies {

inline constexpr const char* speed_kind = "speed";

/// What a cell's time is divided by: V-Clip on the paper's record, of the same scene and shape.
inline constexpr const char* over_reference = "time over reference";
/// Work that no change of the algorithms touches: the reference itself is divided by it.
inline constexpr const char* over_kernel = "time over kernel";

/// Cells that are measured in the same rounds, and divided by one reference: "cold cube8".
[[nodiscard]] std::string gate_group_name(const std::string& scene, const std::string& shape);
/// Group of the cell "gjk lean_f64 cold cube8 batch=yes".
[[nodiscard]] std::string gate_group_of(const std::string& cell);
/// Its table type.
[[nodiscard]] std::string gate_table_of(const std::string& cell);

/// Median of the times' ratios, round by round, with its interval. Null for fewer rounds than an interval
/// takes (measure::least_sample), or where a time is not positive.
[[nodiscard]] std::optional<measure::RecordRow> gate_row(std::string cell, std::string figure,
                                                         std::span<const double> times,
                                                         std::span<const double> beside);

/// Runs are held to the baseline's medians: its intervals decide nothing. A reference that changed has a
/// note.
[[nodiscard]] measure::RecordComparison compare_speed(measure::FigureRecord baseline,
                                                      const measure::FigureRecord& now);

/// Groups with a row that is worse, each once, in the comparison's order.
[[nodiscard]] std::vector<std::string> suspect_groups(const measure::RecordComparison& found);

/// Rows that are worse in `found` take the ratio of `again` where that one's interval begins lower; the
/// others keep theirs, so that a second look can acquit and never accuse.
void look_again(measure::FigureRecord& now, const measure::RecordComparison& found,
                const measure::FigureRecord& again);

}  // namespace edgewise::studies
