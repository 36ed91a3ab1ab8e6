// SPDX-License-Identifier: MIT
//
// Checks that a scene holds enough to recommend anything. A layout wins only against measured layouts: if GJK
// or every small layout is missing, the winner is the best of too few. V-Clip and GJK must therefore
// each have been measured on a small and on a fast layout; one layout may be both.
#pragma once

#include <vector>

#include "edgewise/reports/answer/ranking.hpp"

namespace edgewise::reports {

/// A layout is small for an algorithm if the table that it builds takes at most this: a quarter of the 168
/// bytes per edge that the paper counts.
inline constexpr double small_bytes_per_edge = 42;
/// It is fast if it takes at most this times as long as the fastest layout of its algorithm: in a scene with
/// these bodies in which the most table types of that algorithm were measured.
inline constexpr double fast_ratio = 1.25;

/// Sets `not_measured` of each: "GJK on a small layout", "V-Clip on a fast layout".
void check_contests(std::vector<SceneRanking>& scenes);

/// Returns the rule in one sentence.
[[nodiscard]] std::string contest_rule();

}  // namespace edgewise::reports
