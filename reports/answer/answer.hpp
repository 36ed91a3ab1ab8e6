// SPDX-License-Identifier: MIT
//
// The report's answer: which layout to take in each scene, how sure that is, and what was not measured: the
// sweeps that filled the store, how many figures were measured, and why the others were not. One function
// computes it from a store. Page, Markdown, the end of a sweep and `edgewise advise` show the same.
//
// The ranker says which cell wins a scene and which tie with it (ranking.hpp). A scene in which V-Clip or GJK
// lacks a small or a fast layout recommends nothing (check_contests).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "edgewise/reports/answer/ranking.hpp"
#include "edgewise/reports/reader.hpp"

namespace edgewise::reports {

struct SweepRun {
    std::string command;         ///< "sweep --plan quick"
    std::size_t planned = 0;     ///< cells
    std::size_t done = 0;        ///< number of planned cells that the sweep reached
    std::string started, ended;  ///< UTC, ISO 8601; `ended` is empty when it was stopped
    [[nodiscard]] bool finished() const { return !ended.empty(); }
};

[[nodiscard]] bool any_unfinished(const std::vector<SweepRun>& runs);
/// Returns the number of planned cells that no sweep reached; cells that two plans share count twice.
[[nodiscard]] std::size_t missing_cells(const std::vector<SweepRun>& runs);

struct Gap {
    std::string reason, remedy;
    std::vector<std::string> probes;  ///< the probes that measure the missing figures, in order
    std::size_t figures = 0;
};

struct Gaps {
    std::size_t measured = 0, missing = 0;
    std::vector<Gap> gaps;  ///< the most figures first

    [[nodiscard]] std::size_t figures() const { return measured + missing; }
};

/// Number of the store's cells by status.
struct CellCounts {
    std::size_t cells = 0, verified = 0, failed = 0, unavailable = 0;
    std::size_t stability_rows = 0, stability_failed = 0, stability_verified = 0;  ///< verified: not raw
};

struct Answer {
    Question question;
    std::string shape;          ///< the one asked for, or the reference shape
    std::string body_option;    ///< names it to `edgewise advise`: " --shape box8", " --scene heap.jsonl"
    std::int64_t vertices = 0;  ///< of that shape
    Baseline baseline;
    std::vector<SceneRanking> shared;  ///< scenes with one shared table, in the order of the cells
    std::vector<SceneRanking> own;     ///< scenes with a table for each body
    std::vector<SceneRanking> near;    ///< scenes near contact, with one shared table
    CellCounts counts;
    std::vector<SweepRun> runs;  ///< that filled the store, in order of their commands
    Gaps gaps;

    [[nodiscard]] std::vector<const SceneRanking*> scenes() const;  ///< shared, own, near
};

/// Returns the baseline that the store's meta names, and "vclip x aos_f64" if it names none.
[[nodiscard]] Baseline baseline_of(const ReportData& data);

/// Ranks all scenes. The data must outlive the answer. Scenes without the requested shape are left out. If no
/// shape is requested, each scene answers for the reference shape, else for its largest.
[[nodiscard]] Answer answer_of(const ReportData& data, const Question& question = {});
/// Ranks the scenes only: counts and gaps do not depend on the question.
[[nodiscard]] Answer answer_of_scenes(const ReportData& data, const Question& question);

/// One algorithm and table type for several scenes.
struct Recommendation {
    std::string algorithm, table;
    struct InScene {
        const SceneRanking* scene;
        const RankedCell* cell;  ///< null: not measured in this scene
        bool ties;               ///< with the winner, or it is the winner
    };
    std::vector<InScene> scenes;             ///< one for each scene that counts and has a winner
    std::optional<double> worst_error = {};  ///< over all scenes that recommend something

    /// Returns the scene where it ties with the smallest ratio; where it ties nowhere, of all scenes.
    [[nodiscard]] const InScene& example() const;
    [[nodiscard]] bool beats_baseline_somewhere() const;
};
/// Returns the cell that ties in most scenes and takes at most `store::fast_ratio` times as long as the
/// winner there, and on average no longer than the paper's layout; of several, one that is within 5 % of the
/// fastest of them on average over the scenes; then the choice of most, then that with the smallest tables.
/// If all that tie take longer on average, the paper's layout. Noisy scenes count only if all are too noisy;
/// scenes that recommend nothing never count. Null if no scene with a winner is left.
[[nodiscard]] std::optional<Recommendation> recommendation_of(const std::vector<SceneRanking>& scenes);

/// Returns the largest error of this table type in the scenes that recommend something; null if it has none.
[[nodiscard]] std::optional<double> worst_error_of(const std::vector<SceneRanking>& scenes,
                                                   const std::string& algorithm, const std::string& table);

}  // namespace edgewise::reports
