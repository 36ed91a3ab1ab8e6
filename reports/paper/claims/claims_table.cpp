// SPDX-License-Identifier: MIT
//
// The claims as a grid for the report.
#include "edgewise/reports/paper/claims/claims.hpp"

namespace edgewise::reports {

namespace {

/// A verdict with its number of a footnote where nothing was measured, as in every other table.
GridCell verdict_cell(const Claim& claim) {
    return claim.verdict == "not measured" ? missing_cell(claim.reason) : GridCell{claim.verdict};
}

}  // namespace

TextGrid claims_grid(const ReportData& data) {
    const std::vector<Claim> claims = judge_claims(data);
    TextGrid grid{
        claims_summary(claims),
        columns_of("section|claim|paper|here, with 95 % intervals|verdict|why|rule|depends on times"),
        {}};
    for (const Claim& claim : claims) {
        const bool measured = claim.verdict != "not measured";
        grid.rows.push_back(grid_row(claim.section, claim.claim, claim.paper, claim.ours, verdict_cell(claim),
                                     measured ? claim.reason : "", claim.rule,
                                     claim.deterministic ? "no" : "yes"));
    }
    return grid;
}

}  // namespace edgewise::reports
