// SPDX-License-Identifier: MIT
//
// Finds the cells that a claim is about and takes figures from them as evidence. A cell that is not stored,
// was not verified or lacks the figure gives the reason instead of a number.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/paper/claims/evidence.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

/// Which cells; an empty scene or shape means any. The table is the paper's record in double, one table a
/// body.
struct CellKey {
    std::string scene, shape, algorithm;
    std::string table = "aos_f64";
};

/// A cell of a scene that varies a number, and that number.
struct CurveCell {
    double x = 0;
    const ReportCell* cell = nullptr;
};

struct CurvePoint {
    double x = 0;
    Evidence y;
};

/// Both ends belong to it.
struct CurveRange {
    double low = 0, high = 0;
};

/// The first verified one, else the first; null when there is none.
[[nodiscard]] const ReportCell* find_cell(const ReportData& data, const CellKey& key);
/// In order of x: a number of the scene's parameters, or "vertices". Bodies in a new random orientation each
/// step have no place on an axis of speeds and are left out.
[[nodiscard]] std::vector<CurveCell> cells_along(const ReportData& data, const CellKey& key,
                                                 const std::string& parameter);
[[nodiscard]] std::vector<CurveCell> in_range(const std::vector<CurveCell>& cells, const CurveRange& range);

[[nodiscard]] Evidence figure_of(const ReportCell& cell, const store::FigureName& name);
[[nodiscard]] Evidence figure_of(const ReportData& data, const CellKey& key, const store::FigureName& name);
/// Nanoseconds per query, all pairs as they come: median and interval.
[[nodiscard]] Evidence time_of(const ReportCell& cell);
[[nodiscard]] Evidence time_of(const ReportData& data, const CellKey& key);
/// A cell's time over that of the baseline, V-Clip on aos_f64: the median of the ratios of the rounds, which
/// were timed side by side; where no rounds are stored, the ratio of the two medians.
[[nodiscard]] Evidence time_ratio(const ReportCell& cell, const ReportCell& baseline);
[[nodiscard]] Evidence time_ratio(const ReportData& data, const CellKey& key, const CellKey& baseline);

[[nodiscard]] std::vector<CurvePoint> curve_of(const std::vector<CurveCell>& cells,
                                               const store::FigureName& name);
[[nodiscard]] std::vector<CurvePoint> time_curve(const std::vector<CurveCell>& cells);
/// Time ratios at the numbers that both have.
[[nodiscard]] std::vector<CurvePoint> ratio_curve(const std::vector<CurveCell>& cells,
                                                  const std::vector<CurveCell>& baselines);
/// Quotients at the numbers that both have.
[[nodiscard]] std::vector<CurvePoint> quotient_curve(const std::vector<CurvePoint>& a,
                                                     const std::vector<CurvePoint>& b);
[[nodiscard]] std::vector<Evidence> values_of(const std::vector<CurvePoint>& curve);

}  // namespace edgewise::reports
