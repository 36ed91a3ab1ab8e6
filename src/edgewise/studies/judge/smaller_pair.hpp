// SPDX-License-Identifier: MIT
//
// Finds a smaller pair for which the same respondent is still wrong in the same way.
#pragma once

#include "edgewise/scene/minimise.hpp"
#include "edgewise/studies/judge/pair_judge.hpp"

namespace edgewise::studies {

struct SmallerPair {
    scene::Minimised found;
    PairTruth truth;
    JudgedResponse answer;  ///< to the smaller pair
};

/// Solids stay solids. The error over the scale stays at least a tenth of the original, so that no
/// other failure takes its place. Empty if the respondent is not wrong when it is asked.
[[nodiscard]] std::optional<SmallerPair> smaller_pair(const Respondent& respondent, const scene::Case& pair);

}  // namespace edgewise::studies
