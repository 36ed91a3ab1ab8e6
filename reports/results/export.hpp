// SPDX-License-Identifier: MIT
//
// Figures of a store that a user chooses, in long form: one row per cell and figure, breakdowns included.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

enum class ExportFormat { csv, json };

struct ExportChoice {
    /// Patterns for PROBE.NAME, with * and ? as in a shell (fnmatch); none: the main figures.
    std::vector<std::string> figures = {};
    std::vector<std::string> scenes = {};   ///< by name; none: all
    std::vector<std::string> layouts = {};  ///< layouts or table types; none: all
    ExportFormat format = ExportFormat::csv;
};

/// Returns the cells that the choice names. Throws as export_text does.
[[nodiscard]] std::vector<const ReportCell*> chosen_cells(const ReportData& data, const ExportChoice& choice);

/// CSV: the columns that name the cell, then probe, figure, state ("measured" or "not measured"), value,
/// unit, reason, remedy. JSON: {"cells": [{...the same names..., "figures": [{"figure", "value", "unit",
/// "reason", "remedy"}]}]}, in which a value that was not measured is null and only such a one has a reason.
/// A chosen cell without any chosen figure has one row, without a value. Throws std::runtime_error with one
/// line where a scene or a layout is not in the store, or a pattern matches nothing in the chosen cells.
[[nodiscard]] std::string export_text(const ReportData& data, const ExportChoice& choice);

}  // namespace edgewise::reports
