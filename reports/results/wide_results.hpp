// SPDX-License-Identifier: MIT
//
// The results as files that a reader can open: one per scene, one row per cell, its main figures as columns.
// Files in the folder about/ say what a column is and why a field is empty. Breakdowns stay in the store.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// Returns the text of each file by its name, relative to the folder of results:
/// SCENE.csv: a row per cell of that scene, stability, paging and effort rows likewise; columns that name the
/// cell, then every main figure that any row has, as PROBE.NAME; a field is empty if it was not measured.
/// about/columns.csv: figure, unit, population, repeats, meaning.
/// about/not_measured.csv: per file and figure, how many cells lack it, why, and what would help.
[[nodiscard]] std::map<std::string, std::string> wide_results(const ReportData& data);

/// Writes them into out/results; CSV files of an earlier report there are removed.
void write_results(const ReportData& data, const std::filesystem::path& out);

}  // namespace edgewise::reports
