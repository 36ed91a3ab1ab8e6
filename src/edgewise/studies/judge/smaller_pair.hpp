// SPDX-License-Identifier: MIT
//
// A smaller pair to which the same respondent is still wrong in the same way.
#pragma once

#include "edgewise/scene/minimise.hpp"
#include "edgewise/studies/judge/pair_judge.hpp"

namespace edgewise::studies {

struct SmallerPair {
    scene::Minimised found;
    PairTruth truth;
    JudgedResponse answer;  ///< to the smaller pair
};

/// Solids stay solids. What was wrong stays wrong by as much of the scale at least, up to a factor of ten, so
/// that no other failure takes its place. Empty where the respondent is not wrong when it is asked.
[[nodiscard]] std::optional<SmallerPair> smaller_pair(const Respondent& respondent, const scene::Case& pair);

}  // namespace edgewise::studies
