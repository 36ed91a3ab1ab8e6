// SPDX-License-Identifier: MIT
//
// What was counted over all answers of a cell.
#pragma once

#include <cstdint>

namespace edgewise::measure {

struct AnswerCounts {
    std::uint64_t queries = 0, steps = 0, fallbacks = 0, cycles = 0;
    int max_steps = 0;
    std::uint64_t refinements = 0, escapes = 0;
    std::uint64_t warm = 0, unchanged = 0;  ///< queries that start warm; those that end where they started
    std::uint64_t told = 0;                 ///< warm ones that the pair's bounds answered, in no step
    std::uint64_t warm_steps = 0;           ///< of the steps, those of queries that started warm
    int max_warm_steps = 0, max_cold_steps = 0;
    bool follows_pairs = false;  ///< else every query starts cold
};

}  // namespace edgewise::measure
