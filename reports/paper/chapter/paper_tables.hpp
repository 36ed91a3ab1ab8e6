// SPDX-License-Identifier: MIT
//
// The tables of the chapter on the paper's figures. A grid has no rows if the store lacks its scenes.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// V-Clip and GJK side by side in the scene without coherence, by shape and table type; preprocessing
/// separately.
[[nodiscard]] TextGrid static_grid(const ReportData& data);
/// V-Clip and GJK by body and by distance between the pairs, with the steps and the time of one.
[[nodiscard]] TextGrid static_gap_grid(const ReportData& data);
/// V-Clip over GJK by the margin of the broad phase's boxes, in a moving scene and in the static one.
[[nodiscard]] TextGrid margin_grid(const ReportData& data);
/// Times, steps and verdicts with the paper's tolerance and without it.
[[nodiscard]] TextGrid tolerance_grid(const ReportData& data);
/// Every cell of a scene from a file: its place, how many of its queries are their pair's first, its
/// times, its ratio to the baseline.
[[nodiscard]] TextGrid file_scene_grid(const StoredScene& scene);
/// The paper's cost functions, term by term, and the step as measured: scenes of growing numbers of bodies,
/// or all other scenes.
[[nodiscard]] TextGrid cost_grid(const ReportData& data, bool of_bodies);
/// The cost of each need, relative to the plain cell, which gives witness points.
[[nodiscard]] TextGrid needs_grid(const ReportData& data);
/// Every need, nearness with each margin: time, lines, and how much bounds answer, over all pairs.
[[nodiscard]] TextGrid all_needs_grid(const ReportData& data);
/// Disagreement with exact arithmetic and with Moore-Wilhelms, in percent, by scene.
[[nodiscard]] TextGrid robustness_grid(const ReportData& data);
/// V-Clip as published: how often it is wrong on the queries that the hardened one answers right.
[[nodiscard]] TextGrid raw_vclip_grid(const ReportData& data);
/// The cost of building and refitting a table, and its size.
[[nodiscard]] TextGrid build_grid(const ReportData& data);

}  // namespace edgewise::reports
