// SPDX-License-Identifier: MIT
//
// Claims about how the algorithms work (section 3, and 5 on GJK as an analog of feature stepping).
#include <algorithm>

#include "edgewise/reports/paper/claims/claim_fits.hpp"
#include "edgewise/reports/paper/claims/claim_groups.hpp"

namespace edgewise::reports {

namespace {

/// "Almost constant": less than a factor of 2.3 over the range from 8 to 24578 vertices.
constexpr double almost_constant = 0.1;
/// A scan looks at all vertices, exponent 1.
constexpr double below_scan = 0.8;
/// "Will not have changed, or will have changed to near neighbours": nine in ten; unchanged: half of them.
constexpr double nearly_always = 0.9, often = 0.5;
/// Four points have 15 subsets; half of them is early.
constexpr double half_of_subsets = 7.5;

constexpr ClaimText constant_time{
    "vclip_time_constant",
    "3 V-Clip",
    "V-Clip's running time is almost constant, whatever the number of vertices.",
    "\"almost constant\"",
    "1",
    "Exponent of V-Clip's time over vertices in paper_complexity, 8 to 24578.",
    false};
constexpr ClaimText constant_steps{"vclip_steps_constant",
                                   "3 V-Clip",
                                   "The same in feature steps.",
                                   "\"almost constant\"",
                                   "1",
                                   "Exponent of V-Clip's mean steps over vertices in paper_complexity.",
                                   true};
constexpr ClaimText logarithm{
    "hill_climbing_logarithmic",
    "3 Enhanced GJK",
    "Hill climbing finds a supporting vertex in O(log n).",
    "O(log n)",
    "1",
    "Vertices looked at for a support point in paper_cold, where every climb begins anywhere, by the "
    "bodies that are climbed: relative "
    "residuals "
    "of a + b log n over those of c n^p, root mean squares; the logarithm must fit at least as well.",
    true};
constexpr ClaimText cheaper{"hill_climbing_beats_scan",
                            "3 Enhanced GJK",
                            "Hill climbing looks at fewer vertices than the O(n) of a scan.",
                            "O(n) for a scan",
                            "1",
                            "Exponent of vertices looked at for a support point over vertices in paper_cold; "
                            "clearly below 1.",
                            true};
constexpr ClaimText neighbours{"support_unchanged_or_near",
                               "3 Enhanced GJK",
                               "From step to step supporting vertices stay, or change to near neighbours.",
                               "\"often\"",
                               "1",
                               "Shares of GJK's support points in paper_angular_* at its slowest speed: the "
                               "start vertex or a neighbour of "
                               "it, nine in ten; the start vertex itself, half.",
                               true};
constexpr ClaimText early{
    "subdistance_accepts_early",
    "3 Enhanced GJK",
    "Johnson's algorithm, with subsets in ascending order, is done early.",
    "15 subsets of 4 points",
    "subsets",
    "Subsets tried a call in paper_static and paper_angular_8 at its slowest speed; half "
    "of 15 or fewer.",
    true};
constexpr ClaimText degenerate{
    "dependent_points_fail",
    "3 Enhanced GJK",
    "Johnson's algorithm fails where the points are not affinely independent.",
    "\"or else the algorithm fails\"",
    "queries",
    "GJK's queries of the stability run on aos_f64 whose sub-distance had to be worked out again, in wider "
    "arithmetic or from the start; more than none.",
    true};
constexpr ClaimText analog{
    "gjk_analog_of_features",
    "5",
    "GJK is a numerical analog of feature stepping: both find the same closest features.",
    "\"numerical analog\"",
    "1",
    "Share of checked separated queries in paper_static where GJK's simplex names the features that V-Clip "
    "ends "
    "on; nine in ten at every size.",
    true};

constexpr int sizes[] = {8, 38, 386};

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
    return judge_claim(logarithm, {{"logarithm's residuals over the power law's", ratio, at_most(1)},
                                   {"logarithm's", fits.logarithm, only_shown()},
                                   {"power law's", fits.power, only_shown()},
                                   {"its exponent", growth_exponent(climbs(data)), only_shown()}});
}

Claim judge_neighbours(const ReportData& data) {
    std::vector<ClaimPart> parts;
    for (const int vertices : sizes) {
        parts.push_back({"near, " + paper_shape(vertices),
                         slowest_figure(data, vertices, "gjk", "work.support_near"),
                         at_least(nearly_always)});
        parts.push_back({"unchanged, " + paper_shape(vertices),
                         slowest_figure(data, vertices, "gjk", "work.support_unchanged"), at_least(often)});
    }
    return judge_claim(neighbours, parts);
}

Claim judge_degenerate(const ReportData& data) {
    Evidence all = no_evidence("no stability run of gjk on aos_f64 is stored");
    for (const ReportCell& row : data.stability) {
        if (row.algorithm != "gjk" || row.table != "aos_f64") continue;
        Evidence helped = exact_evidence(all.value.value_or(0));
        for (const store::FigureName& name :
             std::initializer_list<store::FigureName>{"stability.refinements", "stability.fallbacks"}) {
            const measure::Figure figure = row.figure(name);
            helped = sum(helped, figure.value ? exact_evidence(*figure.value) : no_evidence(figure.reason));
        }
        // A family without the figures says nothing of the others.
        if (helped.value || !all.value) all = helped;
    }
    return judge_claim(degenerate, {{"worked out again", all, more_than(0)}});
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
    return judge_claim(early, parts);
}

Claim judge_analog(const ReportData& data) {
    std::vector<ClaimPart> parts;
    for (const int vertices : sizes)
        parts.push_back(
            {paper_shape(vertices),
             figure_of(data, gjk_key("paper_static", paper_shape(vertices)), "work.features_agree"),
             at_least(nearly_always)});
    return judge_claim(analog, parts);
}

}  // namespace

std::vector<Claim> algorithm_claims(const ReportData& data) {
    const auto vclip = cells_along(data, vclip_key("paper_complexity"), "vertices");
    const WantedBand flat = between(-almost_constant, almost_constant);
    return {judge_claim(constant_time, {{"exponent", growth_exponent(time_curve(vclip)), flat}}),
            judge_claim(constant_steps,
                        {{"exponent", growth_exponent(curve_of(vclip, "error.mean_steps")), flat}}),
            judge_logarithm(data),
            judge_claim(cheaper, {{"exponent", growth_exponent(climbs(data)), at_most(below_scan)}}),
            judge_neighbours(data),
            judge_early(data),
            judge_degenerate(data),
            judge_analog(data)};
}

}  // namespace edgewise::reports
