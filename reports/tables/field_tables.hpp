// SPDX-License-Identifier: MIT
//
// Which fields of a table's records travel together, as the fields run stored it: what was advised, what it
// was predicted to save, and what became of that when a table was built so.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// One row per table and algorithm: lines before, predicted and counted, misses, times, verdicts.
[[nodiscard]] TextGrid field_advice_grid(const ReportData& data);
/// The advised records of one row, next to the records of the table.
[[nodiscard]] TextGrid field_groups_grid(const ReportCell& row);
/// Says in one sentence how often advice held in lines and in time, over all rows.
[[nodiscard]] std::string field_verdict(const ReportData& data);

/// The matrix of one row, as an SVG.
[[nodiscard]] std::string field_picture(const ReportCell& row);

// Which fields are read together, as a picture: a matrix of squares, above the diagonal by the same query,
// below it by the same step. One colour, the more of it the more often, and text in the colour of its
// surroundings: it reads on white and on black.

struct CoAccessField {
    std::string name, record;
};

/// Parts from 0 to 1 of what read either field that read both, at [a][b] and [b][a]; at [a][a] of queries or
/// steps that read the field.
using CoAccessParts = std::vector<std::vector<double>>;

/// Returns the matrix as SVG. Fields of one record are adjacent and framed.
[[nodiscard]] std::string draw_co_access(const std::string& title, std::span<const CoAccessField> fields,
                                         const CoAccessParts& by_query, const CoAccessParts& by_step);

}  // namespace edgewise::reports
