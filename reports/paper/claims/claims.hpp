// SPDX-License-Identifier: MIT
//
// What the paper claims (Levey, Peters and O'Sullivan, 2001), sentence by sentence where a sentence can be
// measured, with a verdict that a rule computes from the results store. Rules and their thresholds stand in
// claim_*.cpp, by theme; nothing is judged by hand.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// "reproduced": every part of the evidence meets the rule with its whole interval. "not reproduced": some
/// part misses it with its whole interval. "inconclusive": an interval straddles the rule, or two readings of
/// the paper differ. "not measured": some part is missing, and none refutes.
struct Claim {
    std::string id;       ///< "bytes_per_edge_double"
    std::string section;  ///< of the paper
    std::string claim;    ///< what it says, in our words
    std::string paper;    ///< its figure
    std::string ours;     ///< values, each with its 95 % interval in brackets where there is one
    std::string unit;     ///< of the values that bear no other; "1": a ratio or a share
    std::string verdict;
    std::string reason;          ///< of every verdict but "reproduced"
    std::string rule;            ///< in words, with what is wanted of each part
    bool deterministic = false;  ///< the evidence depends on no time and on no kernel: same in every run
};

/// All claims, in the order of the paper's criteria; the same ones for every store.
[[nodiscard]] std::vector<Claim> judge_claims(const ReportData& data);

/// "N claims: 20 reproduced, 9 not reproduced, 5 inconclusive, 7 not measured", whatever N is.
[[nodiscard]] std::string claims_summary(const std::vector<Claim>& claims);

/// What the command `claims` prints. A claim that is not reproduced is a finding, not an error.
[[nodiscard]] std::string claims_text(const ReportData& data, bool json);

/// One row per claim.
[[nodiscard]] TextGrid claims_grid(const ReportData& data);

}  // namespace edgewise::reports
