// SPDX-License-Identifier: MIT
//
// The sweeps that filled a store: their commands, when they ran, and how many cells each planned. A sweep
// writes this when it starts and again when it ends, so a stopped sweep has no end time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct SweepRun {
    std::string command;         ///< "sweep --plan quick"
    std::size_t planned = 0;     ///< cells
    std::size_t done = 0;        ///< number of planned cells that the sweep reached
    std::string started, ended;  ///< UTC, ISO 8601; `ended` is empty when it was stopped
    [[nodiscard]] bool finished() const { return !ended.empty(); }
};

/// Returns the sweeps of the build that is shown.
[[nodiscard]] std::vector<SweepRun> sweep_runs(const ReportData& data);

[[nodiscard]] bool any_unfinished(const std::vector<SweepRun>& runs);
/// Returns the number of planned cells that no sweep reached; cells that two plans share count twice.
[[nodiscard]] std::size_t missing_cells(const std::vector<SweepRun>& runs);

}  // namespace edgewise::reports
