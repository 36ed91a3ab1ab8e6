// SPDX-License-Identifier: MIT
//
// One answer held against what is known of its pair: proven right by the interval, or else by the exact
// answer.
#pragma once

#include <string>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/studies/campaign/cells.hpp"
#include "edgewise/studies/campaign/known_pair.hpp"

namespace edgewise::studies::campaign {

struct CheckedAnswer {
    bool refused = false;    ///< farther from each other than the precision can compute with
    bool in_band = false;    ///< the pair is nearer to grazing than the cell's band
    bool was_exact = false;  ///< the interval did not tell
    double error = 0;   ///< bound of |d - d*| over scale beyond the band, or of that of the witness points
    std::string wrong;  ///< what is; empty: the answer is right
};

[[nodiscard]] CheckedAnswer check_answer(const Distance& answer, const Cell& cell, const StoredPair& stored,
                                         const std::pair<Pose, Pose>& poses, KnownPair& known);

}  // namespace edgewise::studies::campaign
