// SPDX-License-Identifier: MIT
//
// A cell's answers beside the exact ones, and what was counted over all of them.
#pragma once

#include <cstdint>
#include <optional>

namespace edgewise::measure {

/// One answer beside the exact one.
struct CheckedAnswer {
    bool separated = false, touching = false;  ///< exactly; else overlapping
    bool verdict_wrong = false, in_band = false;
    bool wrong = false;        ///< in its verdict, or further off than allowed in its distance or witnesses
    double error_stored = 0;   ///< |d - d*| / scale, d* of the bodies that the table holds
    double given_away = 0;     ///< what of it was allowed as a tolerance
    double error_given = 0;    ///< the same, d* of the bodies as given
    double witness_error = 0;  ///< | |p_a - p_b| - d | / scale; separated answers only
    /// Whether the verdict is another than the paper's control gives; nothing where it was not asked or has
    /// no answer.
    std::optional<bool> control_disagrees;
};

/// What was counted over all queries of the cell.
struct AnswerCounts {
    std::uint64_t queries = 0, steps = 0, fallbacks = 0, cycles = 0;
    int max_steps = 0;
    std::uint64_t refinements = 0, escapes = 0;
    std::uint64_t warm = 0, unchanged = 0;  ///< started warm; and of these ended where they started
    std::uint64_t told = 0;                 ///< warm ones that the pair's bounds answered, in no step
    std::uint64_t warm_steps = 0;           ///< of the steps, those of queries that started warm
    int max_warm_steps = 0, max_cold_steps = 0;
    bool follows_pairs = false;  ///< else every query starts cold
};

}  // namespace edgewise::measure
