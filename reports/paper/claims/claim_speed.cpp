// SPDX-License-Identifier: MIT
//
// Claims about which algorithm is faster, standing and moving (section 4, "Performance"; figures 4, 6 to 8),
// and about temporal coherence: what speed, rest and caching do (sections 2, 3 and 4).

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

namespace {

/// The paper's two static times, 3.98e-5 s and 3.43e-5 s, give 1.16; ten per cent each way is what another
/// compiler and machine may well change.
constexpr double static_low = 1.16 / 1.1, static_high = 1.16 * 1.1;
/// "Comparable", "very similar": within a factor of two.
constexpr double comparable = 2;

std::vector<CurvePoint> linear_ratios(const ReportData& data) {
    return ratio_curve(cells_along(data, gjk_key("paper_linear_8"), "step_in_dimensions"),
                       cells_along(data, vclip_key("paper_linear_8"), "step_in_dimensions"));
}

Evidence angular_ratio(const ReportData& data, int vertices, const CurveRange& steps) {
    return geometric_mean(values_of(ratio_curve(angular_cells(data, vertices, "gjk", steps),
                                                angular_cells(data, vertices, "vclip", steps))),
                          no_angular_cells(vertices));
}

const char* const no_linear_cells = "no cells of scene paper_linear_8 are stored for both algorithms";

constexpr int static_sizes[] = {4, 8, 38, 386};

/// V-Clip's time over GJK's, body by body: a mean would hide that they differ.
Claim judge_static(const ReportData& data, const std::string& id, const WantedBand& wanted) {
    std::vector<ClaimVariant> variants;
    for (const int vertices : static_sizes) {
        const std::string shape = paper_shape(vertices);
        const Evidence gjk =
            time_ratio(data, gjk_key("paper_static", shape), vclip_key("paper_static", shape));
        variants.push_back({shape, {{"V-Clip over GJK", quotient(exact_evidence(1), gjk), wanted}}});
    }
    return judge_variants(id, "body", variants);
}

Claim judge_simplest(const ReportData& data) {
    std::vector<ClaimPart> parts;
    for (const std::string algorithm : {"vclip", "gjk"}) {
        const auto time = [&](int vertices) {
            return time_of(data, {"paper_static", paper_shape(vertices), algorithm});
        };
        const Evidence complex = smallest({time(38), time(386)}), simple = smallest({time(4), time(8)});
        parts.push_back({algorithm == "gjk" ? "GJK" : "V-Clip", quotient(complex, simple), more_than(1)});
    }
    return judge_claim("simplest_bodies_fastest", parts);
}

Claim judge_comparable(const ReportData& data) {
    const WantedBand band = between(1 / comparable, comparable);
    constexpr CurveRange all_speeds{0, 1e9};
    return judge_claim("times_comparable",
                       {{"linear, 8", geometric_mean(values_of(linear_ratios(data)), no_linear_cells), band},
                        {"angular, 8", angular_ratio(data, 8, all_speeds), band},
                        {"angular, 38", angular_ratio(data, 38, all_speeds), band}});
}

Claim judge_angular(const ReportData& data, const std::string& id, int vertices, const CurveRange& speeds) {
    return both_readings(id, [&](const TimeStepReading& reading) {
        return PartList{
            {"GJK over V-Clip", angular_ratio(data, vertices, in_steps(speeds, reading)), more_than(1)}};
    });
}

}  // namespace

std::vector<Claim> performance_claims(const ReportData& data) {
    return {judge_simplest(data),
            judge_static(data, "static_gjk_faster", more_than(1)),
            judge_static(data, "static_ratio", between(static_low, static_high)),
            judge_claim("linear_vclip_faster",
                        {{"GJK over V-Clip", smallest(values_of(linear_ratios(data)), no_linear_cells),
                          more_than(1)}}),
            judge_angular(data, "angular_vclip_faster_8", 8, figure_6_speeds),
            judge_angular(data, "angular_vclip_faster_38", 38, figures_7_and_8_speeds),
            judge_angular(data, "angular_vclip_faster_386", 386, figures_7_and_8_speeds),
            judge_comparable(data)};
}

namespace {

/// Rotations beyond half a turn per step are smaller ones the other way.
constexpr double coherence_half_turn = 3.1415927;
/// "Often": more often than not.
constexpr double coherence_often = 0.5;
/// "Problems": a quarter more time; "particularly well": no more than a tenth.
constexpr double problem = 1.25, well = 1.1;

/// Cell of paper_caching at 1 rad/s: queries start from the pairs' last answers, or each as if it were the
/// first.
const ReportCell* caching_cell(const ReportData& data, int vertices, const std::string& algorithm,
                               const TimeStepReading& reading, bool cold) {
    const CellKey key{"paper_caching", paper_shape(vertices), algorithm,
                      cold ? "aos_f64 start=cold" : "aos_f64"};
    const auto found = in_range(cells_along(data, key, "rotation_step"), in_steps({1, 1}, reading));
    return found.empty() ? nullptr : found.front().cell;
}

/// Cells of both algorithms, warm and cold.
struct CachingCells {
    const ReportCell *vclip, *vclip_cold, *gjk, *gjk_cold;

    CachingCells(const ReportData& data, int vertices, const TimeStepReading& reading)
        : vclip(caching_cell(data, vertices, "vclip", reading, false)),
          vclip_cold(caching_cell(data, vertices, "vclip", reading, true)),
          gjk(caching_cell(data, vertices, "gjk", reading, false)),
          gjk_cold(caching_cell(data, vertices, "gjk", reading, true)) {}
    [[nodiscard]] bool complete() const { return vclip && vclip_cold && gjk && gjk_cold; }
};

Evidence no_caching_cells() {
    return no_evidence(
        "no cells of scene paper_caching, both algorithms on aos_f64, with and without start=cold "
        "at 1 rad/s, are stored");
}

/// Time that V-Clip saves over time that GJK saves; every ratio was timed in the same rounds as V-Clip's warm
/// queries.
Evidence gains_in_time(const CachingCells& cells) {
    return quotient(
        time_ratio(*cells.vclip_cold, *cells.vclip),
        quotient(time_ratio(*cells.gjk_cold, *cells.vclip), time_ratio(*cells.gjk, *cells.vclip)));
}

Evidence gains_in_steps(const CachingCells& cells) {
    const auto gain = [](const ReportCell& cold, const ReportCell& kept) {
        return quotient(figure_of(cold, store::mean_steps.cold()), figure_of(kept, store::mean_steps.warm()));
    };
    return quotient(gain(*cells.vclip_cold, *cells.vclip), gain(*cells.gjk_cold, *cells.gjk));
}

Claim judge_caching(const ReportData& data, const std::string& id, Evidence (*gains)(const CachingCells&)) {
    return both_readings(id, [&](const TimeStepReading& reading) {
        const auto of = [&](int vertices) {
            const CachingCells cells(data, vertices, reading);
            return cells.complete() ? gains(cells) : no_caching_cells();
        };
        return by_size("V-Clip's gain over GJK's, ", of, more_than(1));
    });
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
    return {judge_claim("speed_costs_steps", {{"V-Clip", growth_of_steps(data, "vclip"), more_than(1)},
                                              {"GJK", growth_of_steps(data, "gjk"), more_than(1)}}),
            judge_kept(data), judge_proximity(data),
            judge_caching(data, "caching_favours_vclip", gains_in_time),
            judge_caching(data, "caching_favours_vclip_in_steps", gains_in_steps)};
}

}  // namespace edgewise::reports
