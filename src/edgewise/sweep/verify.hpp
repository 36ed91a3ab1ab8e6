// SPDX-License-Identifier: MIT
//
// Verify, then measure: a cell's answers beside the exact ones, and whether they are good enough to be timed.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/measure/checked_answer.hpp"
#include "edgewise/sweep/shared_queries.hpp"

namespace edgewise::sweep {

/// The checked answers of one cell. `stored` are the bodies its tables hold; eps the rounding step that
/// computes; `options` what the answers were allowed to give away.
[[nodiscard]] std::vector<measure::CheckedAnswer> check_answers(SharedQueries& shared,
                                                                std::span<const Polyhedron> stored,
                                                                std::span<const Distance> answers, double eps,
                                                                const QueryOptions& options = {});

/// The same of verdicts on nearness (bench::near_answer). `margin`: what a query was asked about. A pair at
/// its margin to within the band where rounding decides may be called either, and one beyond it by no more
/// than the gap tolerance makes of its distance may be called farther.
[[nodiscard]] std::vector<measure::CheckedAnswer> check_nearness(
    SharedQueries& shared, std::span<const Polyhedron> stored, std::span<const Distance> answers, double eps,
    const QueryOptions& options, const std::function<double(const scene::Query&)>& margin);

/// Empty when every checked answer is right; else what is wrong, with the first case as example.
[[nodiscard]] std::string what_is_wrong(const SharedQueries& shared,
                                        std::span<const measure::CheckedAnswer> checked, double eps);

/// `cold`: a flag per query, as cold_starts says; of a scene without warm pairs all count as cold.
[[nodiscard]] measure::AnswerCounts count_answers(std::span<const Distance> answers,
                                                  std::span<const std::uint8_t> cold = {});

}  // namespace edgewise::sweep
