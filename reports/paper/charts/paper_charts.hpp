// SPDX-License-Identifier: MIT
//
// The charts of the chapter on the paper's figures. If the store lacks a chart's scenes, the chart
// has no specification and is not shown.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"

namespace edgewise::reports {

/// The parts of the chapter that hold charts; a chart names its own.
inline constexpr const char* dynamic_section = "dynamic";
inline constexpr const char* scalability_section = "scalability";
inline constexpr const char* thrash_section = "thrash";
inline constexpr const char* own_section = "own";  ///< a user's own scenes

/// Makes it the chart of that figure of the paper: "figure_4".
inline void number_chart(Chart& chart, int figure) {
    chart.is_cited = true;
    chart.name = "figure_" + std::to_string(figure);
}

/// Figure 4: time against linear speed.
[[nodiscard]] Chart paper_linear_chart(const ReportData& data);
/// Figures 6 (8 vertices), 7 (38) and 8 (386): time against angular speed.
[[nodiscard]] Chart paper_angular_chart(const ReportData& data, int figure);
/// Figure 5: tests against bodies.
[[nodiscard]] Chart paper_bodies_chart(const ReportData& data);
/// Time, and bytes of a table, against vertices.
[[nodiscard]] Chart paper_complexity_chart(const ReportData& data);
/// Misses in the caches of 2001 against angular speed.
[[nodiscard]] Chart paper_misses_chart(const ReportData& data);
/// Misses against the size of a cache, of lines and of pages.
[[nodiscard]] Chart paper_reuse_chart(const ReportData& data);
/// Page faults against memory, measured and predicted.
[[nodiscard]] Chart paper_paging_chart(const ReportData& data);
/// Time against bodies on this machine, with its caches.
[[nodiscard]] Chart paper_here_chart(const ReportData& data);
/// Charts of the settings in which the model shows the facts of figure 8, and of the cells that were run.
[[nodiscard]] Chart paper_region_chart(const ReportData& data);
[[nodiscard]] Chart paper_realised_chart(const ReportData& data);
/// Time against what a user's own scene varies.
[[nodiscard]] std::vector<Chart> own_scene_charts(const ReportData& data);

/// Returns all charts of the chapter that have something to draw.
[[nodiscard]] std::vector<Chart> chapter_charts(const ReportData& data);

// A rotation by w between two steps is the same orientation as one of w less whole turns, and one beyond half
// a turn is a smaller one in the opposite direction: coherence knows the folded angle only.

/// w mod 2 pi, then the smaller of that and the rest of the turn: 0 to pi.
[[nodiscard]] inline double folded_angle(double w) {
    constexpr double whole = 2 * std::numbers::pi;
    const double rest = std::fmod(std::abs(w), whole);
    return std::min(rest, whole - rest);
}

/// The mean angle between two random orientations: pi/2 + 2/pi, since the density of the angle t is
/// (1 - cos t) / pi.
inline constexpr double random_angle = std::numbers::pi / 2 + 2 / std::numbers::pi;

}  // namespace edgewise::reports
