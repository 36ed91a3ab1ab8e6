// SPDX-License-Identifier: MIT
//
// Claims about the cost functions of bounding-volume schemes (section 1, equations 1 and 2), and the one
// about the share of collision detection in a whole simulation.
#include "edgewise/reports/paper/claims/claim_groups.hpp"

namespace edgewise::reports {

namespace {

/// Costs of single operations, timed alone, and a step timed whole: a fifth for what they share.
constexpr double least_share = 0.8, most_share = 1.25;

constexpr ClaimText whole_simulation{
    "share_of_simulation",
    "1",
    "Collision detection is often over 95 % of all computation.",
    "95 % (Mirtich)",
    "1",
    "Needs a simulation with forces and contact response, which Edgewise does not have.",
    false};
constexpr ClaimText equation_2{"equation_2_predicts_step",
                               "1",
                               "The cost of a step is the sum over its parts of number times cost: tests of "
                               "boxes, tests of pairs, updates "
                               "of boxes.",
                               "T = Nv Cv + Np Cp + Nu Cu",
                               "1",
                               "Equation 2 over the measured step, at every number of bodies in "
                               "paper_bodies, to a fifth; no interval is "
                               "stored for either.",
                               false};
constexpr ClaimText updates{
    "updates_count",
    "1",
    "Updates of bounding volumes are a cost that the sum needs.",
    "equation 2 enhances equation 1",
    "1",
    "Equation 1, which lacks them, over equation 2 in paper_bodies, at the number of bodies "
    "where it lacks least; a twentieth or more is missing.",
    false};
constexpr double most_without_updates = 0.95;

const char* const no_bodies = "no cells of scene paper_bodies, vclip on aos_f64, are stored";

std::vector<CurvePoint> cost_curve(const ReportData& data, const store::FigureName& name) {
    return curve_of(cells_along(data, vclip_key("paper_bodies"), "bodies"), name);
}

Claim judge_equation_2(const ReportData& data) {
    const auto ratios =
        values_of(quotient_curve(cost_curve(data, "cost.equation_2_ns"), cost_curve(data, "cost.step_ns")));
    return judge_claim(
        equation_2, {{"predicted over measured, least", smallest(ratios, no_bodies), at_least(least_share)},
                     {"most", largest(ratios, no_bodies), at_most(most_share)}});
}

Claim judge_updates(const ReportData& data) {
    const auto ratios = values_of(
        quotient_curve(cost_curve(data, "cost.equation_1_ns"), cost_curve(data, "cost.equation_2_ns")));
    return judge_claim(updates, {{"equation 1 over equation 2, most", largest(ratios, no_bodies),
                                  at_most(most_without_updates)}});
}

}  // namespace

std::vector<Claim> cost_claims(const ReportData& data) {
    const Evidence none = no_evidence("Edgewise simulates no dynamics: there is no whole to take a share of");
    return {judge_claim(whole_simulation, {{"collision detection over all", none, at_least(0.95)}}),
            judge_equation_2(data), judge_updates(data)};
}

}  // namespace edgewise::reports
