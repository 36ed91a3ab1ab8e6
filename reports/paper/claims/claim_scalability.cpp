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

constexpr ClaimText tests_linear{
    "tests_linear_in_bodies",
    "4 Scalability",
    "The number of tests that sweep and prune leaves is linear in the number of bodies.",
    "figure 5: a line",
    "1",
    "Exponent of pairs a step over bodies in paper_bodies, least squares in logarithms.",
    true};
constexpr ClaimText tests_at_600{"tests_at_600_bodies",
                                 "4 Scalability",
                                 "Among 600 bodies some 300 tests are left.",
                                 "300 tests (figure 5)",
                                 "tests",
                                 "Pairs a step at 600 bodies in paper_bodies, between its neighbours where "
                                 "600 is not stored; to a quarter, "
                                 "since it is read off an axis.",
                                 true};
constexpr ClaimText squares{"pairs_reduced",
                            "4 Scalability",
                            "Sweep and prune spares nearly all of the n^2 pairs.",
                            "O(n^2) to O(n)",
                            "1",
                            "Share of all pairs that is tested at 600 bodies in paper_bodies.",
                            true};
constexpr ClaimText sweep_work{
    "sweep_work_linear",
    "4 Scalability",
    "Sweep and prune's own work is linear in the number of bodies as well.",
    "O(n)",
    "1",
    "Exponent of moves in its sorted lists and box tests together, a step, over bodies in paper_bodies.",
    true};
constexpr ClaimText step_linear{
    "step_linear_in_bodies",
    "4 Scalability",
    "The time of a whole step is linear in the number of bodies.",
    "O(n)",
    "1",
    "Exponent of the measured step over bodies in paper_bodies; the store has no interval for it.",
    false};
constexpr ClaimText degrades{
    "more_bodies_slow_queries",
    "2 Scalability",
    "With more bodies most algorithms begin to degrade.",
    "no figure",
    "1",
    "Time a query at the most bodies over that at the fewest in paper_bodies; a twentieth or more.",
    false};
constexpr ClaimText shrinking{"shrinking_alters_rotation",
                              "2 Scalability",
                              "Making room for more bodies by shrinking them alters the effect of their "
                              "rotation; a growing environment "
                              "does not.",
                              "\"will alter\"",
                              "1",
                              "V-Clip's mean steps in paper_bodies_shrinking against paper_bodies, at the "
                              "most bodies that both have: the "
                              "larger over the smaller, a twentieth or more.",
                              true};

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
    return judge_claim(shrinking, {{"difference", difference, at_least(change)}});
}

Claim judge_pairs_reduced(const ReportData& data) {
    const Evidence left = interpolated(
        quotient_curve(cost_curve(data, "cost.pairs_per_step"), cost_curve(data, "cost.all_pairs")),
        figure_5_bodies);
    return judge_claim(squares, {{"tested of all pairs", left, at_most(most_left)}});
}

Claim judge_sweep_work(const ReportData& data) {
    const auto work =
        sum_curve(cost_curve(data, "cost.moves_per_step"), cost_curve(data, "cost.box_tests_per_step"));
    return judge_claim(sweep_work, {{"exponent", growth_exponent(work), at_most(linear_high)}});
}

}  // namespace

std::vector<Claim> scalability_claims(const ReportData& data) {
    const auto pairs = cost_curve(data, "cost.pairs_per_step");
    return {
        judge_claim(tests_linear, {{"exponent", growth_exponent(pairs), between(linear_low, linear_high)}}),
        judge_claim(tests_at_600, {{"at 600 bodies", interpolated(pairs, figure_5_bodies),
                                    between(figure_5_low, figure_5_high)}}),
        judge_pairs_reduced(data),
        judge_sweep_work(data),
        judge_claim(step_linear,
                    {{"exponent", growth_exponent(cost_curve(data, "cost.step_ns")), at_most(linear_high)}}),
        judge_claim(degrades,
                    {{"V-Clip", last_over_first(time_curve(bodies_cells(data, "vclip"))), at_least(change)},
                     {"GJK", last_over_first(time_curve(bodies_cells(data, "gjk"))), at_least(change)}}),
        judge_shrinking(data)};
}

}  // namespace edgewise::reports
