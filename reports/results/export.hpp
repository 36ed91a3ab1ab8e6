// SPDX-License-Identifier: MIT
//
// Figures of a store that a user chooses, in long form: one row per cell and figure, breakdowns included.
#pragma once

#include <filesystem>
#include <map>
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

// The results as files that a reader can open: one per scene, one row per cell, its main figures as columns.
// Files in the folder about/ say what a column is and why a field is empty. Breakdowns stay in the store.

/// Returns the text of each file by its name, relative to the folder of results:
/// SCENE.csv: a row per cell of that scene, stability, paging and effort rows likewise; columns that name the
/// cell, then every main figure that any row has, as PROBE.NAME; a field is empty if it was not measured.
/// about/columns.csv: figure, unit, population, repeats, meaning.
/// about/not_measured.csv: per file and figure, how many cells lack it, why, and what would help.
[[nodiscard]] std::map<std::string, std::string> wide_results(const ReportData& data);

/// Writes them into out/results; CSV files of an earlier report there are removed.
void write_results(const ReportData& data, const std::filesystem::path& out);

}  // namespace edgewise::reports
