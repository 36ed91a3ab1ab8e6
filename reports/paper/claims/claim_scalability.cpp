// SPDX-License-Identifier: MIT
//
// Claims about the number of bodies: the broad phase and figure 5 (sections 2 and 4, "Scalability").
#include "edgewise/reports/paper/claims/claim_cells.hpp"
#include "edgewise/reports/paper/claims/claim_fits.hpp"

namespace edgewise::reports {

namespace {

/// "Linear": an exponent of 1, to a tenth over three powers of ten of bodies.
constexpr double linear_low = 0.9, linear_high = 1.1;
/// Any change beyond a twentieth is an effect.
constexpr double change = 1.05;

std::vector<CurveCell> bodies_cells(const ReportData& data, const std::string& algorithm) {
    return cells_along(data, {"paper_bodies", "", algorithm}, "bodies");
}

std::vector<CurvePoint> cost_curve(const ReportData& data, const store::FigureName& name) {
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

Claim judge_sweep_work(const ReportData& data) {
    const auto work =
        sum_curve(cost_curve(data, "cost.moves_per_step"), cost_curve(data, "cost.box_tests_per_step"));
    return judge_claim("sweep_work_linear", {{"exponent", growth_exponent(work), at_most(linear_high)}});
}

}  // namespace

std::vector<Claim> scalability_claims(const ReportData& data) {
    const auto pairs = cost_curve(data, "cost.pairs_per_step");
    return {
        judge_claim("tests_linear_in_bodies",
                    {{"exponent", growth_exponent(pairs), between(linear_low, linear_high)}}),
        judge_sweep_work(data),
        judge_claim("step_linear_in_bodies",
                    {{"exponent", growth_exponent(cost_curve(data, "cost.step_ns")), at_most(linear_high)}}),
        judge_claim("more_bodies_slow_queries",
                    {{"V-Clip", last_over_first(time_curve(bodies_cells(data, "vclip"))), at_least(change)},
                     {"GJK", last_over_first(time_curve(bodies_cells(data, "gjk"))), at_least(change)}})};
}

}  // namespace edgewise::reports
