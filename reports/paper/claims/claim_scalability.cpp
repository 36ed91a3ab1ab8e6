// SPDX-License-Identifier: MIT
//
// Claims about the number of bodies: the broad phase and figure 5 (sections 2 and 4, "Scalability").
#include <cmath>

#include "edgewise/reports/paper/claims/claim_fits.hpp"
#include "edgewise/reports/paper/claims/claim_groups.hpp"

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

std::vector<CurveCell> bodies_cells(const ReportData& data, const std::string& algorithm) {
    return cells_along(data, {"paper_bodies", "", algorithm}, "bodies");
}

std::vector<CurvePoint> scalability_cost_curve(const ReportData& data, const store::FigureName& name) {
    return curve_of(bodies_cells(data, "vclip"), name);
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
        return curve_of(cells_along(data, vclip_key(scene), "bodies"), "error.mean_steps");
    };
    Evidence difference = no_evidence("the two scenes have no number of bodies in common");
    const std::vector<CurvePoint> shrunk = steps("paper_bodies_shrinking");
    for (const CurvePoint& grown : steps("paper_bodies"))
        for (const CurvePoint& other : shrunk)
            if (grown.x == other.x) difference = larger_over_smaller(grown.y, other.y);
    return judge_claim("shrinking_alters_rotation", {{"difference", difference, at_least(change)}});
}

Claim judge_pairs_reduced(const ReportData& data) {
    const Evidence left = interpolated(quotient_curve(scalability_cost_curve(data, "cost.pairs_per_step"),
                                                      scalability_cost_curve(data, "cost.all_pairs")),
                                       figure_5_bodies);
    return judge_claim("pairs_reduced", {{"tested of all pairs", left, at_most(most_left)}});
}

Claim judge_sweep_work(const ReportData& data) {
    const auto work = sum_curve(scalability_cost_curve(data, "cost.moves_per_step"),
                                scalability_cost_curve(data, "cost.box_tests_per_step"));
    return judge_claim("sweep_work_linear", {{"exponent", growth_exponent(work), at_most(linear_high)}});
}

}  // namespace

std::vector<Claim> scalability_claims(const ReportData& data) {
    const auto pairs = scalability_cost_curve(data, "cost.pairs_per_step");
    return {
        judge_claim("tests_linear_in_bodies",
                    {{"exponent", growth_exponent(pairs), between(linear_low, linear_high)}}),
        judge_claim("tests_at_600_bodies", {{"at 600 bodies", interpolated(pairs, figure_5_bodies),
                                             between(figure_5_low, figure_5_high)}}),
        judge_pairs_reduced(data),
        judge_sweep_work(data),
        judge_claim("step_linear_in_bodies",
                    {{"exponent", growth_exponent(scalability_cost_curve(data, "cost.step_ns")),
                      at_most(linear_high)}}),
        judge_claim("more_bodies_slow_queries",
                    {{"V-Clip", last_over_first(time_curve(bodies_cells(data, "vclip"))), at_least(change)},
                     {"GJK", last_over_first(time_curve(bodies_cells(data, "gjk"))), at_least(change)}}),
        judge_shrinking(data)};
}

}  // namespace edgewise::reports
