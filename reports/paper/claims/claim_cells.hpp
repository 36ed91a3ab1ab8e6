// SPDX-License-Identifier: MIT
//
// Finds the cells that a claim is about and takes figures from them as evidence. A cell that is not stored,
// was not verified or lacks the figure gives the reason instead of a number. How a quantity grows: the
// exponent of a power law through a curve, and whether a logarithm fits it better. Also holds the claims by
// theme and the common parts of their rules: the tables that represent the paper's two programs, and the
// speeds of our scenes that lie in the range of each figure.
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

[[nodiscard]] std::vector<Claim> memory_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> performance_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> coherence_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> scalability_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> complexity_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> robustness_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> ease_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> algorithm_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> thrash_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> paging_claims(const ReportData& data);

/// The paper's V-Clip: its record in double precision.
[[nodiscard]] inline CellKey vclip_key(const std::string& scene, const std::string& shape = {}) {
    return {scene, shape, "vclip"};
}
/// The paper's Enhanced GJK: vertices and neighbours in the same layout, without Voronoi planes.
[[nodiscard]] inline CellKey gjk_key(const std::string& scene, const std::string& shape = {}) {
    return {scene, shape, "gjk"};
}

/// Returns the shape with this number of vertices in the paper's scenes: "cube8", "sphere38".
[[nodiscard]] std::string paper_shape(int vertices);
/// The vertices of the scenes paper_angular_*.
inline constexpr int angular_sizes[] = {8, 38, 386};

/// Axes of angular velocity, rad/s.
inline constexpr CurveRange figure_6_speeds{0, 12.57}, figures_7_and_8_speeds{1, 7};

/// A figure's range in radians per step.
[[nodiscard]] inline CurveRange in_steps(const CurveRange& speeds, const TimeStepReading& reading) {
    return {speeds.low * reading.seconds, speeds.high * reading.seconds};
}

/// One of the scenes paper_angular_*: speeds in a figure's range.
[[nodiscard]] std::vector<CurveCell> angular_cells(const ReportData& data, int vertices,
                                                   const std::string& algorithm, const CurveRange& steps);
/// Returns the reason if angular_cells is empty.
[[nodiscard]] std::string no_angular_cells(int vertices);
/// Returns the cell of scenes paper_angular_* at the slowest speed above 0, the most coherent motion.
[[nodiscard]] const ReportCell* slowest_cell(const ReportData& data, int vertices,
                                             const std::string& algorithm);
/// Returns a figure, or the time, of slowest_cell; none if there is no slowest cell.
[[nodiscard]] Evidence slowest_figure(const ReportData& data, int vertices, const std::string& algorithm,
                                      const store::FigureName& name);
[[nodiscard]] Evidence slowest_time(const ReportData& data, int vertices, const std::string& algorithm);

/// Returns one part for each of `angular_sizes`: the label followed by the shape, the result of `of` for
/// the number of vertices, and `wanted`.
template <class Of>
[[nodiscard]] PartList by_size(const std::string& label, const Of& of, const WantedBand& wanted) {
    PartList parts;
    for (const int vertices : angular_sizes)
        parts.push_back({label + paper_shape(vertices), of(vertices), wanted});
    return parts;
}

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
