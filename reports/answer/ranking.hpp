// SPDX-License-Identifier: MIT
//
// The ranker decides which layout wins a scene, which layouts tie with it, and by how much. Page, map,
// report.md, terminal and `edgewise advise` all show its result and decide nothing themselves.
//
// Ranked are the cells of one scene and shape that answer the scene's own question (those with the fewest
// axes) and were timed in the same rounds as the baseline, by their time over the baseline's. Raw V-Clip is
// not ranked; other libraries are ranked apart and never win.
//
// Dropped are cells with a worst error over the limit or not measured. Outputs show them with the reason, and
// they neither win nor tie.
//
// The interval of a ratio is over the processes if three or more measured the cell, else over the rounds of
// its process; by order statistics in both cases (tables/tables.hpp).
//
// The baseline's own variation: its own cell is timed in the same rounds as the baseline, so these are two
// measurements of one thing, and the ratio of the two is its own variation.
//
// The fastest cell that is not dropped wins. Another ties with it if its interval reaches the winner's, or if
// its ratio is larger by no more than the baseline's own variation. The tie set is the winner and all cells
// that tie with it.
//
// A layout wins only against measured layouts: if GJK or every small layout is missing, the winner is the
// best of too few. V-Clip and GJK must therefore each have been measured on a small and on a fast layout; one
// layout may be both (check_contests). Fast (store::fast_ratio) is a layout beside the fastest of its
// algorithm, in a scene with these bodies in which the most table types of that algorithm were measured.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

struct Question {
    double error_limit = 1e-6;  ///< largest allowed error of a distance, over the scale of the pair
    std::optional<std::string> shape = {};  ///< null: each scene's reference shape
    std::optional<bool> own_tables = {};    ///< a table for each body, or one for all; null: both
    std::optional<double> bodies = {};      ///< number of bodies with a table each; null: any
};

/// A time over the baseline's, with its interval.
struct RatioRange {
    double low, ratio, high;
};

/// An algorithm on a table type in a scene, with the figures by which it is ranked.
struct RankedCell {
    const ReportCell* cell = nullptr;  ///< as the first process measured it
    std::size_t processes = 1;         ///< that measured it
    std::string table;                 ///< the table type, without axes
    double ns = 0;     ///< per query of both kinds of pairs as they come, median over rounds or processes
    double ratio = 0;  ///< to the baseline timed in the same rounds, likewise
    std::optional<RatioInterval> interval;
    std::optional<double> worst_error;  ///< against the bodies as given, over the scale of the pair
    std::optional<double> bytes_per_edge, table_bytes, scene_bytes;  ///< of one table; of all of the scene
    std::optional<double> tables, lines_per_query, steps;
    std::string dropped;  ///< why; empty: it is not

    [[nodiscard]] bool meets_error() const { return dropped.empty(); }
    /// Returns true if the interval is over three or more processes.
    [[nodiscard]] bool holds_between_processes() const { return processes >= 3; }
    [[nodiscard]] double low() const { return interval ? interval->low : ratio; }
    [[nodiscard]] double high() const { return interval ? interval->high : ratio; }
    [[nodiscard]] RatioRange range() const { return {low(), ratio, high()}; }
    /// "V-Clip on aos_f64"; of another library its name.
    [[nodiscard]] std::string name() const;
};

/// `runs` is one cell, as each process measured it. Null if no process timed it with the baseline.
[[nodiscard]] std::optional<RankedCell> ranked_cell(std::span<const ReportCell* const> runs,
                                                    double error_limit);
[[nodiscard]] std::optional<RankedCell> ranked_cell(const ReportCell& cell, double error_limit);

/// "V-Clip" | "GJK"; other names as they are.
[[nodiscard]] std::string algorithm_title(const std::string& algorithm);

/// The baseline's own variation, the same factor in both directions.
struct OwnVariation {
    std::optional<double> factor = {};  ///< at least 1; null: not measured

    [[nodiscard]] double high() const { return factor.value_or(1); }
    [[nodiscard]] double low() const { return 1 / high(); }
    [[nodiscard]] bool holds(double ratio) const { return factor && low() <= ratio && ratio <= high(); }
};

/// Returns true if a cell ties with the fastest one: its interval reaches the fastest one's, or its ratio is
/// larger by no more than the baseline's own variation.
[[nodiscard]] bool ties(const RatioRange& cell, const RatioRange& fastest, const OwnVariation& variation);

/// Ratios are to the time of this cell, as the store names it.
struct Baseline {
    std::string algorithm = "vclip", table = "aos_f64";

    [[nodiscard]] bool is(const std::string& other_algorithm, const std::string& other_table) const {
        return other_algorithm == algorithm && other_table == table;
    }
};

/// The cells of one scene and shape, ranked.
struct SceneRanking {
    std::string label;     ///< name, with the parameters that distinguish it from scenes of the same name
    std::string sentence;  ///< "100 bodies drift and turn by 0.1 rad per step, one shared table"
    std::string shape;
    std::int64_t vertices = 0;
    bool own_tables = false;  ///< a table for each body
    Baseline ratios_to;
    OwnVariation own_variation;
    std::vector<RankedCell> cells;  ///< fastest first, by ratio; dropped ones too
    std::vector<RankedCell> peers;  ///< other libraries, likewise
    /// Cells whose query loops were compiled with default flags, likewise; ratios are to such a baseline.
    std::vector<RankedCell> default_flags;
    std::vector<std::size_t> ties;  ///< the tie set, as indices of `cells`: the winner first
    bool beats_baseline = false;    ///< the winner, by more than its interval and the own variation
    std::string noise;              ///< why no cell can be chosen by these times; empty: one can
    /// Cells to be measured before anything is recommended, "GJK on a small layout" (check_contests).
    std::vector<std::string> not_measured = {};
    /// Measured algorithms without a cell within the error limit: "GJK" (check_contests).
    std::vector<std::string> over_limit = {};

    [[nodiscard]] bool too_noisy() const { return !noise.empty(); }
    [[nodiscard]] bool recommends() const { return not_measured.empty() && over_limit.empty(); }
    /// Returns "not measured: GJK on a small layout; every cell of V-Clip exceeds the error limit"; empty if
    /// the scene recommends.
    [[nodiscard]] std::string why_not() const;
    /// Each of the following functions returns null if no cell matches.
    [[nodiscard]] const RankedCell* winner() const;
    [[nodiscard]] const RankedCell* baseline() const;                          ///< its own cell
    [[nodiscard]] const RankedCell* best(const std::string& algorithm) const;  ///< within the limit
    [[nodiscard]] const RankedCell* best_peer() const;         ///< within the limit, else of known error
    [[nodiscard]] const RankedCell* smallest_of_ties() const;  ///< at most a quarter slower than the winner
    [[nodiscard]] bool ties_with_winner(const RankedCell& cell) const;
    /// The recommended cell: the winner where it beats the baseline, else the smallest of the ties that
    /// is at most a quarter slower than the winner; of a scene that is too noisy the baseline if it ties.
    [[nodiscard]] const RankedCell* choice() const;
    [[nodiscard]] const RankedCell* find(const std::string& algorithm, const std::string& table) const;
};

/// Ranks cells and peers of one scene and shape, one at least. Stored cells of one algorithm and table type
/// are one cell, measured in several processes.
[[nodiscard]] SceneRanking rank_scene(std::span<const ReportCell* const> cells, double error_limit,
                                      const Baseline& baseline);

/// A layout is small for an algorithm if the table that it builds takes at most this: a quarter of the 168
/// bytes per edge that the paper counts.
inline constexpr double small_bytes_per_edge = 42;

/// Sets `not_measured` of each: "GJK on a small layout", "V-Clip on a fast layout"; and `over_limit`.
void check_contests(std::vector<SceneRanking>& scenes);

}  // namespace edgewise::reports
