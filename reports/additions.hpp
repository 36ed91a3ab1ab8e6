// SPDX-License-Identifier: MIT
//
// Additions of folders below reports/ to the report and the program, each with one line in its CMakeLists.txt
// (edgewise_addition): nothing else names such a folder, and deleting it deletes what it adds.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "edgewise/measure/record/record.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/chapters/chapters.hpp"

namespace edgewise::reports {

struct Addition {
    /// Returns all charts that have something to draw; the chapter shows those with a section.
    std::vector<Chart> (*charts)(const ReportData& data);
    /// Returns the chapters that follow the one on hard cases. `charts`: all charts of the report.
    std::vector<Chapter> (*chapters)(const ReportData& data, const std::vector<Chart>& charts);

    /// Returns the output of `edgewise report claims`.
    std::string (*claims_text)(const ReportData& data, bool json);
    /// Returns the figures that the command compares between two stores, with --diff.
    measure::FigureRecord (*claims_record)(const ReportData& data);

    /// Returns the member `decompositions` in the output of `edgewise bytes --json`.
    nlohmann::json (*decompositions)();
    std::string (*decompositions_text)();  ///< the same numbers as text, printed below the tables
};

/// Returns all additions in the order of CMake's lists; generated.
[[nodiscard]] std::span<const Addition> additions();

}  // namespace edgewise::reports
