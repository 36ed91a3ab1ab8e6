// SPDX-License-Identifier: MIT
//
// Claims about the number of bodies: the cost functions of bounding-volume schemes (section 1, equations 1
// and 2), and the one about the share of collision detection in a whole simulation; the broad phase and
// figure 5 (sections 2 and 4, "Scalability").
#include "edgewise/reports/paper/claims/claim_cells.hpp"
#include "edgewise/reports/paper/claims/claim_fits.hpp"

namespace edgewise::reports {

namespace {

/// "Linear": an exponent of 1, to a tenth over three powers of ten of bodies.
constexpr double linear_low = 0.9, linear_high = 1.1;
/// Figure 5 ends at 600 bodies with 300 tests; it is read off an axis and depends on the bodies' shapes.
constexpr double figure_5_bodies = 600, figure_5_low = 225, figure_5_high = 375;
/// What is left of all pairs at 600: a hundredth is a reduction that nobody doubts.
constexpr double most_left = 0.01;
/// Any change beyond a twentieth is an effect.
constexpr double change = 1.05;

/// Costs of single operations, timed alone, and a step timed whole: a fifth for what they share.
constexpr double least_predicted = 0.8, most_predicted = 1.25;

constexpr double most_without_updates = 0.95;

const char* const no_bodies = "no cells of scene paper_bodies, vclip on aos_f64, are stored";

std::vector<CurveCell> bodies_cells(const ReportData& data, const std::string& algorithm) {
    return cells_along(data, {"paper_bodies", "", algorithm}, "bodies");
}

std::vector<CurvePoint> cost_curve(const ReportData& data, const store::FigureName& name) {
    return curve_of(bodies_cells(data, "vclip"), name);
}

Claim judge_equation_2(const ReportData& data) {
    const auto ratios =
        values_of(quotient_curve(cost_curve(data, "cost.equation_2_ns"), cost_curve(data, "cost.step_ns")));
    return judge_claim(
        "equation_2_predicts_step",
        {{"predicted over measured, least", smallest(ratios, no_bodies), at_least(least_predicted)},
         {"most", largest(ratios, no_bodies), at_most(most_predicted)}});
}

Claim judge_updates(const ReportData& data) {
    const auto ratios = values_of(
        quotient_curve(cost_curve(data, "cost.equation_1_ns"), cost_curve(data, "cost.equation_2_ns")));
    return judge_claim("updates_count", {{"equation 1 over equation 2, most", largest(ratios, no_bodies),
                                          at_most(most_without_updates)}});
}

/// Both curves have the same cells.
std::vector<CurvePoint> sum_curve(std::vector<CurvePoint> a, const std::vector<CurvePoint>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i].y = sum(a[i].y, b[i].y);
    return a;
}

Evidence last_over_first(const std::vector<CurvePoint>& curve) {
    if (curve.size() < 2) return no_evidence("paper_bodies has fewer than two numbers of bodies");
    return quotient(curve.back().y, curve.front().y);
}

Evidence larger_over_smaller(const Evidence& a, const Evidence& b) {
    return quotient(largest({a, b}), smallest({a, b}));
}

Claim judge_shrinking(const ReportData& data) {
    const auto steps = [&](const char* scene) {
        return curve_of(cells_along(data, vclip_key(scene), "bodies"), store::mean_steps.warm());
    };
    Evidence difference = no_evidence("the two scenes have no number of bodies in common");
    const std::vector<CurvePoint> shrunk = steps("paper_bodies_shrinking");
    for (const CurvePoint& grown : steps("paper_bodies"))
        for (const CurvePoint& other : shrunk)
            if (grown.x == other.x) difference = larger_over_smaller(grown.y, other.y);
    return judge_claim("shrinking_alters_rotation", {{"difference", difference, at_least(change)}});
}

Claim judge_pairs_reduced(const ReportData& data) {
    const Evidence left = interpolated(
        quotient_curve(cost_curve(data, "cost.pairs_per_step"), cost_curve(data, "cost.all_pairs")),
        figure_5_bodies);
    return judge_claim("pairs_reduced", {{"tested of all pairs", left, at_most(most_left)}});
}

Claim judge_sweep_work(const ReportData& data) {
    const auto work =
        sum_curve(cost_curve(data, "cost.moves_per_step"), cost_curve(data, "cost.box_tests_per_step"));
    return judge_claim("sweep_work_linear", {{"exponent", growth_exponent(work), at_most(linear_high)}});
}

}  // namespace

std::vector<Claim> cost_claims(const ReportData& data) {
    const Evidence none = no_evidence("Edgewise simulates no dynamics: there is no whole to take a share of");
    return {judge_claim("share_of_simulation", {{"collision detection over all", none, at_least(0.95)}}),
            judge_equation_2(data), judge_updates(data)};
}

std::vector<Claim> scalability_claims(const ReportData& data) {
    const auto pairs = cost_curve(data, "cost.pairs_per_step");
    return {
        judge_claim("tests_linear_in_bodies",
                    {{"exponent", growth_exponent(pairs), between(linear_low, linear_high)}}),
        judge_claim("tests_at_600_bodies", {{"at 600 bodies", interpolated(pairs, figure_5_bodies),
                                             between(figure_5_low, figure_5_high)}}),
        judge_pairs_reduced(data),
        judge_sweep_work(data),
        judge_claim("step_linear_in_bodies",
                    {{"exponent", growth_exponent(cost_curve(data, "cost.step_ns")), at_most(linear_high)}}),
        judge_claim("more_bodies_slow_queries",
                    {{"V-Clip", last_over_first(time_curve(bodies_cells(data, "vclip"))), at_least(change)},
                     {"GJK", last_over_first(time_curve(bodies_cells(data, "gjk"))), at_least(change)}}),
        judge_shrinking(data)};
}

}  // namespace edgewise::reports
