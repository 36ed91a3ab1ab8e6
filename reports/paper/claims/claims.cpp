// SPDX-License-Identifier: MIT
//
// The claims together: as a summary, as a grid for the report, and as the command `claims` prints them.
#include "edgewise/reports/paper/claims/claims.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "edgewise/reports/paper/claims/claim_cells.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

using ClaimJson = nlohmann::ordered_json;

std::string claims_json(const ReportData& data, const std::vector<Claim>& claims) {
    ClaimJson all = ClaimJson::array();
    for (const Claim& claim : claims)
        all.push_back({{"id", claim.id},
                       {"section", claim.section},
                       {"claim", claim.claim},
                       {"paper", claim.paper},
                       {"ours", claim.ours},
                       {"unit", claim.unit},
                       {"verdict", claim.verdict},
                       {"reason", claim.reason},
                       {"rule", claim.rule},
                       {"deterministic", claim.deterministic}});
    const ClaimJson machine = ClaimJson::parse(data.build.machine_json, nullptr, false);
    const ClaimJson out = {{"claims", all}, {"machine", machine.is_discarded() ? nullptr : machine}};
    return out.dump(-1, ' ', false, ClaimJson::error_handler_t::replace) + "\n";
}

/// A verdict with its number of a footnote where nothing was measured, as in every other table.
GridCell verdict_cell(const Claim& claim) {
    return claim.verdict == "not measured" ? missing_cell(claim.reason) : GridCell{claim.verdict};
}

}  // namespace

std::vector<Claim> judge_claims(const ReportData& data) {
    std::vector<Claim> all;
    for (const auto group :
         {cost_claims, performance_claims, coherence_claims, scalability_claims, complexity_claims,
          memory_claims, thrash_claims, paging_claims, robustness_claims, ease_claims, algorithm_claims}) {
        std::vector<Claim> claims = group(data);
        std::move(claims.begin(), claims.end(), std::back_inserter(all));
    }
    return all;
}

std::string claims_summary(const std::vector<Claim>& claims) {
    std::string out = plural(claims.size(), "claim") + ":";
    const char* comma = " ";
    for (const char* verdict : {"reproduced", "not reproduced", "inconclusive", "not measured"}) {
        const auto count = std::count_if(claims.begin(), claims.end(),
                                         [&](const Claim& claim) { return claim.verdict == verdict; });
        out += fmt::format("{}{} {}", comma, count, verdict);
        comma = ", ";
    }
    return out;
}

/// A line of short columns, then one for each longer text.
std::string claims_text(const ReportData& data, bool json) {
    const std::vector<Claim> claims = judge_claims(data);
    if (json) return claims_json(data, claims);
    std::size_t id = 0, section = 0;
    for (const Claim& claim : claims) {
        id = std::max(id, claim.id.size());
        section = std::max(section, claim.section.size());
    }
    std::string out = fmt::format("{:<{}}  {:<{}}  {}\n", "claim", id, "section", section, "verdict");
    for (const Claim& claim : claims) {
        out += fmt::format("{:<{}}  {:<{}}  {}\n", claim.id, id, claim.section, section, claim.verdict);
        out += fmt::format("    {}\n    paper: {}\n", claim.claim, claim.paper);
        if (!claim.ours.empty()) out += fmt::format("    here: {}\n", claim.ours);
        if (!claim.reason.empty()) out += fmt::format("    why: {}\n", claim.reason);
    }
    return out + claims_summary(claims) + "\n";
}

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
