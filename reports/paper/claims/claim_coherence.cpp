// SPDX-License-Identifier: MIT
//
// Claims about temporal coherence: what speed, rest and caching do (sections 2, 3 and 4).
#include <algorithm>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

namespace {

/// Rotations beyond half a turn per step are smaller ones the other way.
constexpr double coherence_half_turn = 3.1415927;
/// "Often": more often than not.
constexpr double coherence_often = 0.5;
/// "Problems": a quarter more time; "particularly well": no more than a tenth.
constexpr double problem = 1.25, well = 1.1;

/// Mean steps, from incoherent to as coherent as can be.
Evidence gain_in_steps(const ReportData& data, int vertices, const std::string& algorithm) {
    return quotient(
        figure_of(data, {"paper_static", paper_shape(vertices), algorithm}, store::mean_steps.cold()),
        slowest_figure(data, vertices, algorithm, store::mean_steps.warm()));
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

Evidence growth_of_steps(const ReportData& data, const std::string& algorithm) {
    std::vector<CurvePoint> curve =
        curve_of(angular_cells(data, 8, algorithm, {0, coherence_half_turn}), store::mean_steps.warm());
    std::erase_if(curve, [](const CurvePoint& point) { return !(point.x > 0); });
    if (curve.size() < 2) return no_evidence("paper_angular_8 has fewer than two speeds for " + algorithm);
    return quotient(curve.back().y, curve.front().y);
}

Claim judge_proximity(const ReportData& data) {
    const auto slow_down = [&](const std::string& algorithm) {
        std::vector<Evidence> all;
        for (const int vertices : angular_sizes)
            all.push_back(quotient(time_of(data, {"paper_proximity", paper_shape(vertices), algorithm}),
                                   slowest_time(data, vertices, algorithm)));
        return geometric_mean(all);
    };
    const Evidence vclip = slow_down("vclip"), gjk = slow_down("gjk");
    return judge_claim("proximity_divides", {{"slowed the more", largest({vclip, gjk}), at_least(problem)},
                                             {"slowed the less", smallest({vclip, gjk}), at_most(well)},
                                             {"V-Clip", vclip, only_shown()},
                                             {"GJK", gjk, only_shown()}});
}

Claim judge_kept(const ReportData& data) {
    return both_readings("last_answer_kept", [&](const TimeStepReading& reading) {
        const auto kept = [&](int vertices) {
            const auto cells =
                angular_cells(data, vertices, "vclip", in_steps(figures_7_and_8_speeds, reading));
            return cells.empty() ? no_evidence(no_angular_cells(vertices))
                                 : figure_of(*cells.front().cell, "work.unchanged");
        };
        return by_size("V-Clip, ", kept, at_least(coherence_often));
    });
}

}  // namespace

std::vector<Claim> coherence_claims(const ReportData& data) {
    const std::string gain = "V-Clip's gain over GJK's, ";
    const auto in_time = [&](int vertices) { return gains_in_time(data, vertices); };
    const auto in_steps = [&](int vertices) { return gains_in_steps(data, vertices); };
    return {judge_claim("speed_costs_steps", {{"V-Clip", growth_of_steps(data, "vclip"), more_than(1)},
                                              {"GJK", growth_of_steps(data, "gjk"), more_than(1)}}),
            judge_kept(data), judge_proximity(data),
            judge_claim("caching_favours_vclip", by_size(gain, in_time, more_than(1))),
            judge_claim("caching_favours_vclip_in_steps", by_size(gain, in_steps, more_than(1)))};
}

}  // namespace edgewise::reports
