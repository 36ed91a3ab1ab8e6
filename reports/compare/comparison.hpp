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

/// Returns the line that says how much the baseline's own cells vary.
[[nodiscard]] std::string noise_text(const StoreComparison& comparison);

// Formats that CI reads. All of them have the rule of significance of the comparison: a difference that
// intervals and slack allow counts as none.

inline constexpr const char *ci_markdown = "markdown", *ci_github = "github", *ci_bencher = "bencher",
                            *ci_junit = "junit";

/// Returns a comparison of any records in one of these formats. `markdown`: a table of at most five rows for
/// a pull request (regressions and improvements of exact figures and of times, and rows without a number on
/// both sides: how many, and mean and range of the change), the verdict, and the full text, folded. `github`:
/// the new figures for github-action-benchmark (customSmallerIsBetter). `bencher`: the new figures in Bencher
/// Metric Format. `junit`: a test case for each row. The two formats of figures leave out cells that only one
/// record has. `old_name`: the old record's file; figures of a record with one cell are called after it.
[[nodiscard]] std::string ci_text(const measure::RecordComparison& found, const std::string& format,
                                  const std::string& old_name);

}  // namespace edgewise::reports
