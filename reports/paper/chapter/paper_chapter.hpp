// SPDX-License-Identifier: MIT
//
// The chapter on the paper's figures: the claims and how they fare, then part by part what the paper shows,
// with its tables. A grid has no rows if the store lacks its scenes. The answer on the thrash at 386
// vertices, which the paper saw in its figure 8 and explained in two ways, is computed from the store by
// rules (thrash_evidence.hpp).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "edgewise/reports/page/chapters/chapters.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/claims/claim_rules.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// Own scenes, where there are any; then the paper, in two lines where none of its scenes was measured.
/// `charts`: those that the report has.
[[nodiscard]] std::vector<Chapter> paper_chapters(const ReportData& data, const std::vector<Chart>& charts);

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

/// Cache, paging or both; from what size, speed, number of bodies and memory on; what each layout does to it;
/// and which sentence of the paper holds. Figures that the store lacks are named with the reason.
[[nodiscard]] std::string thrash_paragraph(const ReportData& data);
/// Returns its sentence on the measuring machine: the ratio of V-Clip's times at 386 and 38 vertices, at the
/// fastest rotation, with a table for every body and with one for all, and the same ratio for GJK.
[[nodiscard]] std::string thrash_here(const ReportData& data);
/// What each layout and sharing does to it at 386 vertices: knees, misses and memory time.
[[nodiscard]] TextGrid thrash_grid(const ReportData& data);
/// Every limit of the paging run: page faults measured and predicted.
[[nodiscard]] TextGrid paging_grid(const ReportData& data);

// What the paper leaves open and we had to assume, each varied alone around figures 6 to 8 in the middle of
// their common axis, 4 rad/s (the tolerance, which it names, at 1 rad/s): what the findings on V-Clip against
// GJK and on 386 vertices against 38 are under each value.

struct AssumedValue {
    std::string assumption;  ///< "time step"
    std::string value;       ///< "1/60 s"
    bool ours = false;       ///< the value that the paper's scenes have
    /// Time per query over GJK's, by size: angular_sizes (claim_cells.hpp).
    std::array<Evidence, 3> vclip_over_gjk;
    Evidence vclip_growth, gjk_growth;  ///< time at 386 vertices over that at 38
};

/// Returns all values in a fixed order; a value without stored cells gives a reason.
[[nodiscard]] std::vector<AssumedValue> assumed_values(const ReportData& data);

/// One row per value, those of one assumption side by side; no rows where none of the scenes is stored.
[[nodiscard]] TextGrid assumptions_grid(const ReportData& data);

/// Says which findings hold under every value, and under which values the rest hold; empty if nothing is
/// stored.
[[nodiscard]] std::string assumptions_paragraph(const ReportData& data);

}  // namespace edgewise::reports
