// SPDX-License-Identifier: MIT
//
// Claims about the number of vertices: figures 6 to 8 next to each other (section 4, "Scalability"); about
// the number of bodies: the broad phase and figure 5 (sections 2 and 4); and about how the algorithms work
// (section 3, and 5 on GJK as an analog of feature stepping).

#include <algorithm>
#include <cmath>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

namespace {

/// "Performs as it did": within a factor of two, which is below the resolution of the figures' three axes.
constexpr double as_before = 2;
/// The axes of figures 6 and 7 end at 7e-5 s and 1e-4 s, a factor of 1.43: not below 1, not above 2.
constexpr double scaled_low = 1, scaled_high = 2;
/// The axis of figure 8 ends at 1.2e-3 s, 12 times that of figure 7; V-Clip's curve is what fills it. Half of
/// it is still beyond what complexity alone gives.
constexpr double least_rise = 6;
/// A curve of time over speed should rise; a fall by a fifth from one speed to a higher one is erratic.
constexpr double erratic = 1.2;

std::vector<CurvePoint> times(const ReportData& data, int vertices, const std::string& algorithm,
                              const TimeStepReading& reading) {
    return time_curve(angular_cells(data, vertices, algorithm, in_steps(figures_7_and_8_speeds, reading)));
}

/// Returns the quotient of one algorithm's times at two sizes.
Evidence complexity_growth(const ReportData& data, const std::string& algorithm, int more, int fewer,
                           const TimeStepReading& reading) {
    const auto growths =
        quotient_curve(times(data, more, algorithm, reading), times(data, fewer, algorithm, reading));
    return geometric_mean(values_of(growths), no_angular_cells(more) + ", or none of " + paper_shape(fewer));
}

Evidence largest_fall(const std::vector<CurvePoint>& curve) {
    std::vector<Evidence> falls;
    for (std::size_t i = 1; i < curve.size(); ++i) falls.push_back(quotient(curve[i - 1].y, curve[i].y));
    if (falls.empty()) return no_evidence("fewer than two speeds are stored in the range");
    return largest(falls);
}

Claim judge_scaled(const ReportData& data) {
    return both_readings("both_scale_8_to_38", [&](const TimeStepReading& reading) {
        const WantedBand band = between(scaled_low, scaled_high);
        return PartList{{"V-Clip", complexity_growth(data, "vclip", 38, 8, reading), band},
                        {"GJK", complexity_growth(data, "gjk", 38, 8, reading), band}};
    });
}

Claim judge_flat(const ReportData& data) {
    return both_readings("gjk_flat_to_386", [&](const TimeStepReading& reading) {
        return PartList{
            {"386 over 8", complexity_growth(data, "gjk", 386, 8, reading), at_most(as_before)},
            {"386 over 38", complexity_growth(data, "gjk", 386, 38, reading), at_most(as_before)}};
    });
}

Claim judge_slower(const ReportData& data) {
    return both_readings("vclip_slower_at_386", [&](const TimeStepReading& reading) {
        const CurveRange steps = in_steps(figures_7_and_8_speeds, reading);
        const auto gjk =
            ratio_curve(angular_cells(data, 386, "gjk", steps), angular_cells(data, 386, "vclip", steps));
        const Evidence mean = geometric_mean(values_of(gjk), no_angular_cells(386));
        return PartList{{"V-Clip over GJK", quotient(exact_evidence(1), mean), more_than(1)}};
    });
}

Claim judge_rise(const ReportData& data) {
    return both_readings("vclip_rises_at_386", [&](const TimeStepReading& reading) {
        const auto longest = [&](int vertices) {
            return largest(values_of(times(data, vertices, "vclip", reading)), no_angular_cells(vertices));
        };
        return PartList{{"longest, 386 over 38", quotient(longest(386), longest(38)), at_least(least_rise)}};
    });
}

Claim judge_uneven(const ReportData& data) {
    return both_readings("vclip_erratic_at_386", [&](const TimeStepReading& reading) {
        return PartList{
            {"V-Clip's largest fall", largest_fall(times(data, 386, "vclip", reading)), at_least(erratic)},
            {"GJK's", largest_fall(times(data, 386, "gjk", reading)), less_than(erratic)}};
    });
}

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

std::vector<Claim> complexity_claims(const ReportData& data) {
    return {judge_scaled(data), judge_flat(data), judge_slower(data), judge_rise(data), judge_uneven(data)};
}

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
    if (!std::ranges::all_of(curve, is_scanned)) std::erase_if(curve, is_scanned);
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
