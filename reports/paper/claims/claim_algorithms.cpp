// SPDX-License-Identifier: MIT
//
// Claims about how the algorithms work (section 3, and 5 on GJK as an analog of feature stepping).
#include <algorithm>

#include "edgewise/reports/paper/claims/claim_cells.hpp"
#include "edgewise/reports/paper/claims/claim_fits.hpp"

namespace edgewise::reports {

namespace {

/// "Almost constant": less than a factor of 2.3 over the range from 8 to 98306 vertices.
constexpr double almost_constant = 0.1;
/// A scan looks at all vertices, exponent 1.
constexpr double below_scan = 0.8;
/// "Will not have changed, or will have changed to near neighbours": nine in ten; unchanged: half of them.
constexpr double nearly_always = 0.9, algorithms_often = 0.5;
/// Four points have 15 subsets; half of them is early.
constexpr double half_of_subsets = 7.5;

std::vector<CurvePoint> climbs(const ReportData& data) {
    std::vector<CurvePoint> curve =
        curve_of(cells_along(data, gjk_key("paper_cold"), "vertices"), "work.vertices_per_support");
    // Bodies that are scanned do not climb; without any that do, the reason is theirs.
    const auto is_scanned = [](const CurvePoint& point) { return !point.y.value; };
    if (!std::all_of(curve.begin(), curve.end(), is_scanned)) std::erase_if(curve, is_scanned);
    return curve;
}

Claim judge_logarithm(const ReportData& data) {
    const LogOrPower fits = log_or_power(climbs(data));
    // A perfect power law would have nothing to divide by.
    constexpr double rounding = 1e-9;
    const Evidence ratio =
        quotient(no_less_than(fits.logarithm, rounding), no_less_than(fits.power, rounding));
    return judge_claim("hill_climbing_logarithmic",
                       {{"logarithm's residuals over the power law's", ratio, at_most(1)},
                        {"logarithm's", fits.logarithm, only_shown()},
                        {"power law's", fits.power, only_shown()},
                        {"its exponent", growth_exponent(climbs(data)), only_shown()}});
}

Claim judge_neighbours(const ReportData& data) {
    std::vector<ClaimPart> parts;
    for (const int vertices : angular_sizes) {
        parts.push_back({"near, " + paper_shape(vertices),
                         slowest_figure(data, vertices, "gjk", "work.support_near"),
                         at_least(nearly_always)});
        parts.push_back({"unchanged, " + paper_shape(vertices),
                         slowest_figure(data, vertices, "gjk", "work.support_unchanged"),
                         at_least(algorithms_often)});
    }
    return judge_claim("support_unchanged_or_near", parts);
}

Claim judge_early(const ReportData& data) {
    const CellKey standing = gjk_key("paper_static", "cube8");
    std::vector<ClaimPart> parts = {
        {"standing", figure_of(data, standing, "work.subsets_tried"), at_most(half_of_subsets)},
        {"turning", slowest_figure(data, 8, "gjk", "work.subsets_tried"), at_most(half_of_subsets)}};
    for (const char* size : {"1", "2", "3", "4"})
        parts.push_back({std::string("accepted with ") + size + " points, standing",
                         figure_of(data, standing, store::FigureName("work.accepted_{number}").of(size)),
                         only_shown(), "1"});
    return judge_claim("subdistance_accepts_early", parts);
}

}  // namespace

std::vector<Claim> algorithm_claims(const ReportData& data) {
    const auto vclip = cells_along(data, vclip_key("paper_complexity"), "vertices");
    const auto gjk = cells_along(data, gjk_key("paper_complexity"), "vertices");
    const WantedBand flat = between(-almost_constant, almost_constant);
    const store::FigureName steps = store::mean_steps.warm();
    return {judge_claim("vclip_time_constant", {{"exponent", growth_exponent(time_curve(vclip)), flat},
                                                {"GJK's", growth_exponent(time_curve(gjk)), only_shown()}}),
            judge_claim("vclip_steps_constant",
                        {{"exponent", growth_exponent(curve_of(vclip, steps)), flat},
                         {"GJK's iterations", growth_exponent(curve_of(gjk, steps)), only_shown()}}),
            judge_logarithm(data),
            judge_claim("hill_climbing_beats_scan",
                        {{"exponent", growth_exponent(climbs(data)), at_most(below_scan)}}),
            judge_neighbours(data),
            judge_early(data)};
}

}  // namespace edgewise::reports
