// SPDX-License-Identifier: MIT
//
// See claims.hpp.
#include "edgewise/reports/paper/claims/claims.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>

#include "edgewise/reports/paper/claims/claim_groups.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

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

}  // namespace edgewise::reports
