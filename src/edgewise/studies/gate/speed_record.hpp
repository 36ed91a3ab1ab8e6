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

/// Figure of a cell's time over V-Clip's on the paper's record, for the same scene and shape.
inline constexpr const char* over_reference = "time over reference";
/// Figure of the reference's own time over that of work that no change of the algorithms touches.
inline constexpr const char* over_kernel = "time over kernel";

/// Cells that are measured in the same rounds, and divided by one reference: "cold cube8".
[[nodiscard]] std::string gate_group_name(const std::string& scene, const std::string& shape);
/// Returns the group of the cell "gjk lean_f64 cold cube8 batch=yes".
[[nodiscard]] std::string gate_group_of(const std::string& cell);
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

}  // namespace edgewise::studies
