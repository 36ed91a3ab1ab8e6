// SPDX-License-Identifier: MIT
//
// One answer of a cell checked against what is known of its pair, and what is wrong with it in words.
#pragma once

#include <string>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/studies/campaign/cells.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::studies::campaign {

/// An answer that there is.
[[nodiscard]] truth::CheckedAnswer check_answer(const Distance& answer, const Cell& cell,
                                                const truth::StoredPair& stored,
                                                const truth::PosesOfPair& poses, truth::ProvenPair& known);

/// Empty where the answer is right.
[[nodiscard]] std::string what_is_wrong(const truth::CheckedAnswer& checked, const Distance& answer,
                                        const truth::StoredPair& stored, const truth::PosesOfPair& poses,
                                        truth::ProvenPair& known);

}  // namespace edgewise::studies::campaign
