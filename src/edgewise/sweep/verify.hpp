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
#include "edgewise/measure/answer_counts.hpp"
#include "edgewise/sweep/shared_queries.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::sweep {

/// The checked answers of one cell. `stored` are the bodies its tables hold; eps the rounding step that
/// computes, which alone decides the errors allowed; `options` what the answers were allowed to give away.
[[nodiscard]] std::vector<truth::CheckedAnswer> check_answers(SharedQueries& shared,
                                                              std::span<const Polyhedron> stored,
                                                              std::span<const Distance> answers, double eps,
                                                              const QueryOptions& options = {});

/// The same of verdicts on nearness (bench::near_answer). `margin`: what a query was asked about.
[[nodiscard]] std::vector<truth::CheckedAnswer> check_nearness(
    SharedQueries& shared, std::span<const Polyhedron> stored, std::span<const Distance> answers, double eps,
    const QueryOptions& options, const std::function<double(const scene::Query&)>& margin);

/// Empty when every checked answer is right; else what is wrong, with the first case as example.
[[nodiscard]] std::string what_is_wrong(const SharedQueries& shared,
                                        std::span<const truth::CheckedAnswer> checked, double eps);

/// `cold`: a flag per query, as cold_starts says; of a scene without warm pairs all count as cold.
[[nodiscard]] measure::AnswerCounts count_answers(std::span<const Distance> answers,
                                                  std::span<const std::uint8_t> cold = {});

}  // namespace edgewise::sweep
