// SPDX-License-Identifier: MIT
//
// Claims about which algorithm is faster, standing and moving (section 4, "Performance"; figures 4, 6 to 8).
#include <fmt/core.h>

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

}  // namespace edgewise::reports
