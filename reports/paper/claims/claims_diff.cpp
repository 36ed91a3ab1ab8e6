// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/claims/claims_diff.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

using DiffJson = nlohmann::ordered_json;

std::string side_text(const char* side, const Claim& claim) {
    std::string text = fmt::format("    {}: {}", side, claim.verdict);
    if (!claim.ours.empty()) text += "; here: " + claim.ours;
    if (!claim.reason.empty()) text += "; why: " + claim.reason;
    return text + "\n";
}

DiffJson side_json(const Claim& claim) {
    return {{"verdict", claim.verdict}, {"ours", claim.ours}, {"reason", claim.reason}};
}

std::string diff_text(const std::vector<ClaimDifference>& differing, std::size_t claims,
                      const ReportData& first, const ReportData& second) {
    std::string text;
    for (const auto& [a, b] : differing) {
        text += fmt::format("{}  {}\n    {}\n    paper: {}\n", a.id, a.section, a.claim, a.paper);
        text += side_text("first", a) + side_text("second", b);
    }
    return text + fmt::format("{} of {} differ in verdict; first: build {}, second: build {}\n",
                              differing.size(), plural(claims, "claim"), first.build.id, second.build.id);
}

std::string diff_json(const std::vector<ClaimDifference>& differing, std::size_t claims,
                      const ReportData& first, const ReportData& second) {
    DiffJson rows = DiffJson::array();
    for (const auto& [a, b] : differing)
        rows.push_back({{"id", a.id},
                        {"section", a.section},
                        {"claim", a.claim},
                        {"paper", a.paper},
                        {"unit", a.unit},
                        {"rule", a.rule},
                        {"deterministic", a.deterministic},
                        {"first", side_json(a)},
                        {"second", side_json(b)}});
    const DiffJson all = {{"claims", claims},
                          {"differing", std::move(rows)},
                          {"builds", {{"first", first.build.id}, {"second", second.build.id}}}};
    return input::json_text(all) + "\n";
}

}  // namespace

std::vector<ClaimDifference> differing_claims(const ReportData& first, const ReportData& second) {
    std::vector<Claim> ours = judge_claims(first), theirs = judge_claims(second);
    std::vector<ClaimDifference> differing;
    for (std::size_t i = 0; i < ours.size(); ++i)  // the same ones for every store
        if (ours[i].verdict != theirs.at(i).verdict)
            differing.push_back({std::move(ours[i]), std::move(theirs[i])});
    return differing;
}

StoreDifference claims_diff(const ReportData& first, const ReportData& second, bool json) {
    const std::vector<ClaimDifference> differing = differing_claims(first, second);
    const std::size_t claims = judge_claims(first).size();
    return {json ? diff_json(differing, claims, first, second) : diff_text(differing, claims, first, second),
            !differing.empty()};
}

}  // namespace edgewise::reports
