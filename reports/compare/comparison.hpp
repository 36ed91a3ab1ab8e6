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

// Formats for CI. All of them use the comparison's rule of significance: a change within the intervals and
// the slack counts as no change.

inline constexpr const char *ci_markdown = "markdown", *ci_github = "github", *ci_bencher = "bencher",
                            *ci_junit = "junit";

/// Returns the comparison of two records in a format for CI. `old_name`: the old record's file, after which
/// the figures of a record with one cell are named.
///
/// `markdown`: a comment for a pull request. It has a table, the verdict, and the full text, folded. The
/// table has at most five rows: regressions and improvements of exact figures, the same of times, and rows
/// that lack a number in one record. Each row has a count, and the mean and the range of the change.
///
/// `github`: the new figures for github-action-benchmark (customSmallerIsBetter). `bencher`: the new figures
/// in Bencher Metric Format. Both leave out cells that only one record has.
///
/// `junit`: a test case for each row.
[[nodiscard]] std::string ci_text(const measure::RecordComparison& found, const std::string& format,
                                  const std::string& old_name);

}  // namespace edgewise::reports
