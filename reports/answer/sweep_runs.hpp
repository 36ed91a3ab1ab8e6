// SPDX-License-Identifier: MIT
//
// The sweeps that filled a store: their commands, when they ran, and how many cells each was to measure. A
// sweep writes this when it starts and again when it ends, so one that was stopped is known by it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct SweepRun {
    std::string command;         ///< "sweep --plan quick"
    std::size_t planned = 0;     ///< cells
    std::string started, ended;  ///< UTC, ISO 8601; `ended` is empty when it was stopped
    [[nodiscard]] bool finished() const { return !ended.empty(); }
};

/// Of the build that is shown.
[[nodiscard]] std::vector<SweepRun> sweep_runs(const ReportData& data);

/// How many cells of the plans are not in the store: none where every sweep finished. Several plans may share
/// cells, so of several sweeps that were stopped this is the largest lack.
[[nodiscard]] std::size_t missing_cells(const std::vector<SweepRun>& runs, std::size_t stored);

}  // namespace edgewise::reports
