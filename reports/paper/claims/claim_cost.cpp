// SPDX-License-Identifier: MIT
//
// Claims about the cost functions of bounding-volume schemes (section 1, equations 1 and 2), and the one
// about the share of collision detection in a whole simulation.
#include "edgewise/reports/paper/claims/claim_groups.hpp"

namespace edgewise::reports {

namespace {

/// Costs of single operations, timed alone, and a step timed whole: a fifth for what they share.
constexpr double least_share = 0.8, most_share = 1.25;

constexpr double most_without_updates = 0.95;

const char* const no_bodies = "no cells of scene paper_bodies, vclip on aos_f64, are stored";

std::vector<CurvePoint> cost_cost_curve(const ReportData& data, const store::FigureName& name) {
    return curve_of(cells_along(data, vclip_key("paper_bodies"), "bodies"), name);
}

Claim judge_equation_2(const ReportData& data) {
    const auto ratios = values_of(
        quotient_curve(cost_cost_curve(data, "cost.equation_2_ns"), cost_cost_curve(data, "cost.step_ns")));
    return judge_claim(
        "equation_2_predicts_step",
        {{"predicted over measured, least", smallest(ratios, no_bodies), at_least(least_share)},
         {"most", largest(ratios, no_bodies), at_most(most_share)}});
}

Claim judge_updates(const ReportData& data) {
    const auto ratios = values_of(quotient_curve(cost_cost_curve(data, "cost.equation_1_ns"),
                                                 cost_cost_curve(data, "cost.equation_2_ns")));
    return judge_claim("updates_count", {{"equation 1 over equation 2, most", largest(ratios, no_bodies),
                                          at_most(most_without_updates)}});
}

}  // namespace

std::vector<Claim> cost_claims(const ReportData& data) {
    const Evidence none = no_evidence("Edgewise simulates no dynamics: there is no whole to take a share of");
    return {judge_claim("share_of_simulation", {{"collision detection over all", none, at_least(0.95)}}),
            judge_equation_2(data), judge_updates(data)};
}

}  // namespace edgewise::reports
