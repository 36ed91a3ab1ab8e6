// SPDX-License-Identifier: MIT
//
// The answer for one scene and shape: who is fastest within the error limit, who ties with it, and what
// stands beside them. Only cells that answer the scene's own question are compared: those with the fewest
// axes. Other libraries and raw V-Clip are judged, and never win.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/reports/answer/candidate.hpp"
#include "edgewise/reports/answer/question.hpp"

namespace edgewise::reports {

/// What the baseline's own cell differs by from the baseline that is timed beside every cell of its scene:
/// two measurements of one thing. The same factor is allowed in both directions.
struct NoiseBand {
    std::optional<double> factor = {};  ///< at least 1; null: not measured

    [[nodiscard]] double high() const { return factor.value_or(1); }
    [[nodiscard]] double low() const { return 1 / high(); }
    [[nodiscard]] bool holds(double ratio) const { return factor && low() <= ratio && ratio <= high(); }
};

/// What every ratio is to, as the store names it.
struct Baseline {
    std::string algorithm = "vclip", table = "aos_f64";
};

struct SceneAnswer {
    std::string scene, label;  ///< name; name with what tells it from its namesakes
    std::string sentence;      ///< "100 bodies drift and turn by 0.1 rad per step, one shared table"
    std::string shape;
    std::int64_t vertices = 0, edges = 0;
    bool own_tables = false;  ///< a table for each body
    Baseline ratios_to;
    NoiseBand noise;
    std::vector<Candidate> candidates;  ///< fastest first, by ratio
    std::vector<Candidate> peers;       ///< other libraries, likewise
    std::vector<std::size_t> ties;      ///< places of those that tie with the winner, fastest first; it too
    std::vector<std::size_t> out;       ///< places of those over the error limit, or without an error
    bool beats_baseline = false;        ///< the winner, by more than its interval and the noise band
    bool too_noisy = false;             ///< the winner's interval spans more than a factor of 2
    /// What must be measured before anything is recommended, "GJK on a small layout" (contest.hpp).
    std::vector<std::string> not_measured = {};

    [[nodiscard]] bool recommends() const { return not_measured.empty(); }
    /// Each null where there is none.
    [[nodiscard]] const Candidate* winner() const;
    [[nodiscard]] const Candidate* baseline() const;  ///< its own cell, beside the one timed with every cell
    [[nodiscard]] const Candidate* best(const std::string& algorithm) const;  ///< within the limit
    [[nodiscard]] const Candidate* best_peer() const;         ///< within the limit, else the fastest
    [[nodiscard]] const Candidate* smallest_of_ties() const;  ///< at most a quarter slower than the winner
    [[nodiscard]] bool ties_with_winner(const Candidate& candidate) const;
    /// What a reader should take: the winner where it beats the baseline, else the smallest of the ties that
    /// is at most a quarter slower than the winner; of a scene that is too noisy the baseline if it ties.
    [[nodiscard]] const Candidate* choice() const;
    [[nodiscard]] const Candidate* find(const std::string& algorithm, const std::string& table) const;
};

/// Of cells and peers of one scene and shape, one at least. The one rule by which two tie, in every table,
/// map and text: the slower one's interval reaches the winner's, or its ratio is larger by no more than the
/// noise factor of the scene.
[[nodiscard]] SceneAnswer scene_answer(std::span<const ReportCell* const> cells, const Question& question,
                                       const Baseline& baseline);

}  // namespace edgewise::reports
