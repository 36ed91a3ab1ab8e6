// SPDX-License-Identifier: MIT
//
// A store as a record of figures, and two stores compared cell by cell. Figures that are the same in every
// run are exact rows; times are ratios to the baseline of their own run, with intervals. Cells are paired by
// scene, parameters, shape, algorithm, table type and axes.
#pragma once

#include <string>

#include "edgewise/measure/record/comparison.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct StoreComparison {
    measure::RecordComparison found;  ///< cells by their titles, changes of time with what they are made of
    double noise_low = 1, noise_high = 1;  ///< the baseline's own cells over itself, in both stores
};

/// A time is worse where its whole interval lies beyond `slack` and beyond the noise.
[[nodiscard]] StoreComparison compare(const ReportData& before, const ReportData& after, double slack);

/// Returns the comparison as text for a terminal; `old_name` is the file of the older store.
[[nodiscard]] std::string comparison_text(const StoreComparison& comparison, const std::string& old_name);

}  // namespace edgewise::reports
