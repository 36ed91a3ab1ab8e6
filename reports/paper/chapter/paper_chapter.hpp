// SPDX-License-Identifier: MIT
//
// The chapter on the paper's figures: the claims and how they fare, then part by part what the paper shows,
// with its tables. A grid has no rows if the store lacks its scenes. The answer on the thrash at 386
// vertices, which the paper saw in its figure 8 and explained in two ways, is computed from the store by
// rules (stored_scene.hpp).
#pragma once

#include <array>
#include <optional>
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

// Rows of the study of figure 8 in the store (studies/thrash): which combinations of what the paper leaves
// open give the four facts that the figure states, and the cells that were made real.

/// The only processor with every setting in the store.
inline constexpr const char* region_machine = "pentium2_deschutes";

/// Which facts hold, as thrash.facts adds them.
inline constexpr unsigned rises = 1, takes_as_long = 2, spares_gjk = 4, erratic = 8;
inline constexpr unsigned all_but_erratic = rises | takes_as_long | spares_gjk, all_facts = 15;

struct ScoredSetting {
    double bodies = 0, memory_mib = 0, fault_ns = 0;
    unsigned facts = 0;

    [[nodiscard]] bool has(unsigned wanted) const { return (facts & wanted) == wanted; }
};

/// A row of the factorial.
struct ThrashRow {
    const ReportCell* cell = nullptr;
    std::string mechanism, machine;
    double intensity = 0, time_step = 0;
    bool own_tables = false;
    std::vector<ScoredSetting> settings;  ///< of the region's machine alone

    [[nodiscard]] std::size_t count(unsigned wanted) const;
    /// "whole table transform", "builds 0.01".
    [[nodiscard]] std::string name() const;
    /// "aos_f64, own tables, steps of 1/60 s".
    [[nodiscard]] std::string tables() const;
};
[[nodiscard]] std::vector<ThrashRow> thrash_rows(const ReportData& data);

/// A curve of a cell made real.
struct RealisedRow {
    const ReportCell* cell = nullptr;
    int number = 0;
    std::string what;  ///< "1: 200 bodies, 24 MiB, 4000 us a fault; aos_f64, ..."
    struct Point {
        double speed, measured_us, predicted_us;
        std::optional<double> measured_faults, predicted_faults, model_us;
    };
    std::vector<Point> points;

    /// Returns the larger ratio of measured and predicted, in either direction.
    [[nodiscard]] double worst_ratio() const;
};
[[nodiscard]] std::vector<RealisedRow> realised_rows(const ReportData& data);

/// What can be said of figure 8: which mechanisms can make it, which cannot, which the paper's words favour,
/// and what remains unknown. Empty where the study was not run.
[[nodiscard]] std::string settled_paragraph(const ReportData& data);

[[nodiscard]] TextGrid mechanism_grid(const ReportData& data);
[[nodiscard]] TextGrid realised_grid(const ReportData& data);

}  // namespace edgewise::reports
