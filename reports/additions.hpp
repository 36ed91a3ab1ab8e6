// SPDX-License-Identifier: MIT
//
// What folders below reports/ add to the report and to the program, each with one line in its CMakeLists.txt
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
    /// All that have something to draw; those with a section stand in the chapter.
    std::vector<Chart> (*charts)(const ReportData& data);
    /// They stand after the chapter on hard cases. `charts`: all of the report's.
    std::vector<Chapter> (*chapters)(const ReportData& data, const std::vector<Chart>& charts);

    const char *command, *command_does;  ///< a command that reads a store, and what --help says of it
    /// What the command prints.
    std::string (*command_text)(const ReportData& data, bool json);
    /// What it compares of two stores, with --diff.
    measure::FigureRecord (*command_record)(const ReportData& data);

    const char* bytes_key;  ///< what stands under this key in what `edgewise bytes --json` prints
    nlohmann::json (*bytes_json)();
    std::string (*bytes_text)();  ///< the same below its tables
};

/// In the order of CMake's lists; generated.
[[nodiscard]] std::span<const Addition> additions();

}  // namespace edgewise::reports
