// SPDX-License-Identifier: MIT
//
// The claims by theme, one file each, and what their rules have in common: which tables stand for the paper's
// two programs, and which of our speeds lie in the range of which of its figures.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/paper/claims/claim_cells.hpp"
#include "edgewise/reports/paper/claims/claim_rules.hpp"

namespace edgewise::reports {

[[nodiscard]] std::vector<Claim> memory_claims(const ReportData& data);
[[nodiscard]] std::vector<Claim> cost_claims(const ReportData& data);
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

/// The shape of so many vertices in the paper's scenes: "cube8", "sphere38".
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
/// The reason when there are none.
[[nodiscard]] std::string no_angular_cells(int vertices);
/// Of the same scenes, at their slowest speed above 0: as coherent as a moving scene is.
[[nodiscard]] const ReportCell* slowest_cell(const ReportData& data, int vertices,
                                             const std::string& algorithm);
/// Its figure, or its time; none where there is no such cell.
[[nodiscard]] Evidence slowest_figure(const ReportData& data, int vertices, const std::string& algorithm,
                                      const store::FigureName& name);
[[nodiscard]] Evidence slowest_time(const ReportData& data, int vertices, const std::string& algorithm);

/// A part for each of these sizes: its label and the shape, what `of` gives for the vertices, the same
/// wanted.
template <class Of>
[[nodiscard]] PartList by_size(const std::string& label, const Of& of, const WantedBand& wanted) {
    PartList parts;
    for (const int vertices : angular_sizes)
        parts.push_back({label + paper_shape(vertices), of(vertices), wanted});
    return parts;
}

}  // namespace edgewise::reports
