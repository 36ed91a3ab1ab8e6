// SPDX-License-Identifier: MIT
//
// Claims about temporal coherence: what speed, rest and caching do (sections 2, 3 and 4).
#include <algorithm>

#include "edgewise/reports/paper/claims/claim_groups.hpp"

namespace edgewise::reports {

namespace {

/// Rotations beyond half a turn a step are smaller ones the other way.
constexpr double half_turn = 3.1415927;
/// "Often": more often than not.
constexpr double often = 0.5;
/// "Problems": a quarter more time; "particularly well": no more than a tenth.
constexpr double problem = 1.25, well = 1.1;

constexpr ClaimText caching_time{
    "caching_favours_vclip",
    "4 Performance",
    "V-Clip's cached features save it more than GJK's cached vertices save GJK: this explains why V-Clip is "
    "slower in static and faster in dynamic tests.",
    "\"significantly more beneficial\"",
    "1",
    "Gain: time in paper_static over time in paper_angular_* at its slowest speed. V-Clip's gain over GJK's, "
    "at "
    "each size: the same number as GJK over V-Clip turning, divided by GJK over V-Clip standing, and each of "
    "these "
    "was timed side by side.",
    false};
constexpr ClaimText caching_steps{
    "caching_favours_vclip_in_steps",
    "4 Performance",
    "The same in steps: V-Clip saves more of its feature steps than GJK of its iterations.",
    "\"significantly more beneficial\"",
    "1",
    "As caching_favours_vclip, with mean steps for times.",
    true};
constexpr ClaimText speed{
    "speed_costs_steps",
    "2 Performance",
    "The faster bodies turn, the less coherence is left to exploit.",
    "\"less coherence\"",
    "1",
    "Mean steps in paper_angular_8 at its fastest speed up to half a turn a step over those "
    "at its slowest above 0.",
    true};
constexpr ClaimText kept{"last_answer_kept",
                         "2 Performance",
                         "At low speeds the solution of the last time step gives the present one.",
                         "\"exploit temporal coherence\"",
                         "1",
                         "Share of warm queries that end where they began, in paper_angular_* at its slowest "
                         "speed; more often than not.",
                         true};
constexpr ClaimText proximity{
    "proximity_divides",
    "2 Performance",
    "Constant close proximity is a problem for some algorithms, while others do well in it.",
    "no figure",
    "1",
    "Time in paper_proximity over that in paper_angular_* at its slowest speed, geometric mean over 8, 38 "
    "and 386 "
    "vertices: one algorithm's a quarter more or worse, the other's no more than a tenth.",
    false};

constexpr int sizes[] = {8, 38, 386};

/// Mean steps, from incoherent to as coherent as can be.
Evidence gain_in_steps(const ReportData& data, int vertices, const std::string& algorithm) {
    return quotient(figure_of(data, {"paper_static", paper_shape(vertices), algorithm}, "error.mean_steps"),
                    slowest_figure(data, vertices, algorithm, "error.mean_steps"));
}

Evidence gains_in_steps(const ReportData& data, int vertices) {
    return quotient(gain_in_steps(data, vertices, "vclip"), gain_in_steps(data, vertices, "gjk"));
}

Evidence gains_in_time(const ReportData& data, int vertices) {
    const ReportCell *vclip = slowest_cell(data, vertices, "vclip"),
                     *gjk = slowest_cell(data, vertices, "gjk");
    if (!vclip || !gjk) return no_evidence(no_angular_cells(vertices));
    const std::string shape = paper_shape(vertices);
    return quotient(time_ratio(*gjk, *vclip),
                    time_ratio(data, gjk_key("paper_static", shape), vclip_key("paper_static", shape)));
}

Claim judge_caching(const ReportData& data, const ClaimText& text,
                    Evidence (*gains)(const ReportData&, int)) {
    std::vector<ClaimPart> parts;
    for (const int vertices : sizes)
        parts.push_back(
            {"V-Clip's gain over GJK's, " + paper_shape(vertices), gains(data, vertices), more_than(1)});
    return judge_claim(text, parts);
}

Evidence growth_of_steps(const ReportData& data, const std::string& algorithm) {
    std::vector<CurvePoint> curve =
        curve_of(angular_cells(data, 8, algorithm, {0, half_turn}), "error.mean_steps");
    std::erase_if(curve, [](const CurvePoint& point) { return !(point.x > 0); });
    if (curve.size() < 2) return no_evidence("paper_angular_8 has fewer than two speeds for " + algorithm);
    return quotient(curve.back().y, curve.front().y);
}

Claim judge_kept(const ReportData& data) {
    std::vector<ClaimPart> parts;
    for (const int vertices : sizes)
        parts.push_back({"V-Clip, " + paper_shape(vertices),
                         slowest_figure(data, vertices, "vclip", "work.unchanged"), at_least(often)});
    return judge_claim(kept, parts);
}

Claim judge_proximity(const ReportData& data) {
    const auto slow_down = [&](const std::string& algorithm) {
        std::vector<Evidence> all;
        for (const int vertices : sizes)
            all.push_back(quotient(time_of(data, {"paper_proximity", paper_shape(vertices), algorithm}),
                                   slowest_time(data, vertices, algorithm)));
        return geometric_mean(all);
    };
    const Evidence vclip = slow_down("vclip"), gjk = slow_down("gjk");
    return judge_claim(proximity, {{"slowed the more", largest({vclip, gjk}), at_least(problem)},
                                   {"slowed the less", smallest({vclip, gjk}), at_most(well)},
                                   {"V-Clip", vclip, only_shown()},
                                   {"GJK", gjk, only_shown()}});
}

}  // namespace

std::vector<Claim> coherence_claims(const ReportData& data) {
    return {judge_claim(speed, {{"V-Clip", growth_of_steps(data, "vclip"), more_than(1)},
                                {"GJK", growth_of_steps(data, "gjk"), more_than(1)}}),
            judge_kept(data), judge_proximity(data), judge_caching(data, caching_time, gains_in_time),
            judge_caching(data, caching_steps, gains_in_steps)};
}

}  // namespace edgewise::reports
