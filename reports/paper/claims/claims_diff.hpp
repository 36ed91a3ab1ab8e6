// SPDX-License-Identifier: MIT
//
// Claims whose verdict differs between two stores: two runs, machines, builds or seeds of one replication.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/additions.hpp"
#include "edgewise/reports/paper/claims/claims.hpp"

namespace edgewise::reports {

/// One claim as either store has it.
struct ClaimDifference {
    Claim first, second;
};

/// In the order of the claims. Both stores are judged by this program's rules.
[[nodiscard]] std::vector<ClaimDifference> differing_claims(const ReportData& first,
                                                            const ReportData& second);

/// What `claims --diff` prints: each such claim with both verdicts, figures and reasons, then how many. As
/// JSON: {"claims", "differing": [{"id", "section", "claim", "paper", "unit", "rule", "deterministic",
/// "first": {"verdict", "ours", "reason"}, "second": {...}}], "builds": {"first", "second"}}.
[[nodiscard]] StoreDifference claims_diff(const ReportData& first, const ReportData& second, bool json);

}  // namespace edgewise::reports
