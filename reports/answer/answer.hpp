// SPDX-License-Identifier: MIT
//
// The report's answer: which layout to take, scene by scene, how sure that is, and what was not measured. One
// function from a store to it; page, Markdown, the end of a sweep and `edgewise advise` show the same object.
//
// The ranker says which cell wins a scene and which tie with it (ranking.hpp). A scene in which V-Clip or GJK
// lacks a small or a fast layout recommends nothing (contest.hpp).
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/gaps.hpp"
#include "edgewise/reports/answer/question.hpp"
#include "edgewise/reports/answer/ranking.hpp"
#include "edgewise/reports/answer/sweep_runs.hpp"

namespace edgewise::reports {

/// The cells of the store, by status.
struct CellCounts {
    std::size_t cells = 0, verified = 0, failed = 0, unavailable = 0;
    std::size_t stability_rows = 0, stability_failed = 0;
};

struct Answer {
    Question question;
    std::string shape;          ///< the one asked for, or the reference shape
    std::int64_t vertices = 0;  ///< of that shape
    Baseline baseline;
    std::vector<SceneRanking> shared;  ///< scenes whose bodies share a table, in the order of the cells
    std::vector<SceneRanking> own;     ///< scenes with a table for each body
    CellCounts counts;
    std::vector<SweepRun> runs;  ///< that filled the store, in order of their commands
    Gaps gaps;

    [[nodiscard]] std::vector<const SceneRanking*> scenes() const;  ///< shared, then own
};

/// "vclip x aos_f64" in the store's meta; where it is silent, that.
[[nodiscard]] Baseline baseline_of(const ReportData& data);

/// The data must outlive the answer. Of scenes without the asked shape none; without an asked shape each
/// scene answers for the reference shape if it has it, else for its largest.
[[nodiscard]] Answer answer_of(const ReportData& data, const Question& question = {});
/// Its scenes alone: counts, runs and gaps are the same whatever is asked.
[[nodiscard]] Answer answer_of_scenes(const ReportData& data, const Question& question);

/// One algorithm and table type for several scenes.
struct Recommendation {
    std::string algorithm, table;
    struct InScene {
        const SceneRanking* scene;
        const RankedCell* cell;  ///< null: not measured there
        bool ties;               ///< with the winner, or is it
    };
    std::vector<InScene> scenes;  ///< one for each scene that has a winner and recommends something
    std::optional<double> worst_error = {};  ///< over all scenes that recommend something

    [[nodiscard]] const RankedCell& example() const;  ///< where it ties; the smallest ratio
    [[nodiscard]] bool is(const Baseline& baseline) const;
    [[nodiscard]] bool beats_baseline_somewhere() const;
};
/// The most scenes in which it ties, then the fewest in which it is beaten, then the most whose choice it is,
/// then the smallest tables. Scenes that are too noisy count only where all are, and those that recommend
/// nothing never. Null where no scene is left with a winner.
[[nodiscard]] std::optional<Recommendation> recommendation_of(const std::vector<SceneRanking>& scenes);

/// The largest error of this table type in the scenes that recommend something; null where it has none.
[[nodiscard]] std::optional<double> worst_error_of(const std::vector<SceneRanking>& scenes,
                                                   const std::string& algorithm, const std::string& table);

}  // namespace edgewise::reports
