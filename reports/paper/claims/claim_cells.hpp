// SPDX-License-Identifier: MIT
//
// Finds the cells that a claim is about and takes figures from them as evidence. A cell that is not stored,
// was not verified or lacks the figure gives the reason instead of a number. How a quantity grows: the
// exponent of a power law through a curve, and whether a logarithm fits it better.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/paper/claims/claim_rules.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// Which cells; an empty scene or shape means any. The table is the paper's record in double, one table a
/// body.
struct CellKey {
    std::string scene, shape, algorithm;
    std::string table = "aos_f64";
};

/// Reads "gjk paper_static cube8 aos_f64 start=cold": algorithm, scene, shape, table type with its axes.
[[nodiscard]] CellKey key_of(const std::string& text);

/// A cell of a scene that varies a number, and that number.
struct CurveCell {
    double x = 0;
    const ReportCell* cell = nullptr;
};

struct CurvePoint {
    double x = 0;
    Evidence y;
};

/// A closed range.
struct CurveRange {
    double low = 0, high = 0;
};

/// Returns the first verified cell with this key, else the first; null if the key has no cell.
[[nodiscard]] const ReportCell* find_cell(const ReportData& data, const CellKey& key);
/// Returns cells in order of x: a number of the scene's parameters, or "vertices". Bodies with random
/// orientations in each step have no place on an axis of speeds and are left out.
[[nodiscard]] std::vector<CurveCell> cells_along(const ReportData& data, const CellKey& key,
                                                 const std::string& parameter);
[[nodiscard]] std::vector<CurveCell> in_range(const std::vector<CurveCell>& cells, const CurveRange& range);

/// Returns a figure by its whole name, "error.checked"; throws std::out_of_range if the vocabulary lacks it.
[[nodiscard]] measure::Figure stored_figure(const ReportCell& cell, const std::string& name);
/// Evidence from a verified cell, else the reason why there is none.
[[nodiscard]] Evidence figure_of(const ReportCell& cell, const std::string& name);
[[nodiscard]] Evidence figure_of(const ReportData& data, const CellKey& key, const std::string& name);
/// Nanoseconds per query, all pairs as they come: median and interval.
[[nodiscard]] Evidence time_of(const ReportCell& cell);
[[nodiscard]] Evidence time_of(const ReportData& data, const CellKey& key);
/// A cell's time over that of the baseline, V-Clip on aos_f64: the median of the ratios of the rounds, which
/// were timed side by side; where no rounds are stored, the ratio of the two medians.
[[nodiscard]] Evidence time_ratio(const ReportCell& cell, const ReportCell& baseline);
[[nodiscard]] Evidence time_ratio(const ReportData& data, const CellKey& key, const CellKey& baseline);

/// Time ratios at the numbers that both have.
[[nodiscard]] std::vector<CurvePoint> ratio_curve(const std::vector<CurveCell>& cells,
                                                  const std::vector<CurveCell>& baselines);
/// A point at each number that both have, joined from both.
[[nodiscard]] std::vector<CurvePoint> joined_curve(const std::vector<CurvePoint>& a,
                                                   const std::vector<CurvePoint>& b,
                                                   Evidence (*join)(const Evidence&, const Evidence&));

/// Returns the shape with this number of vertices in the paper's scenes: "cube8", "sphere38".
[[nodiscard]] std::string paper_shape(int vertices);
/// The vertices of the scenes paper_angular_*.
inline constexpr int angular_sizes[] = {8, 38, 386};

/// The slope of log y over log x by least squares. Its interval is what the slope can be while every y stays
/// within its own interval. None with fewer than three points above 0, for which a slope has no test.
[[nodiscard]] Evidence growth_exponent(const std::vector<CurvePoint>& curve);

/// Root mean squares of the relative residuals of a + b log x and of c x^p, each fitted to make its own
/// small.
struct LogOrPower {
    Evidence logarithm, power;
};
[[nodiscard]] LogOrPower log_or_power(const std::vector<CurvePoint>& curve);

}  // namespace edgewise::reports
