// SPDX-License-Identifier: MIT
#include "edgewise/reports/paper/claims/assumptions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "edgewise/reports/paper/claims/claim_cells.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// The scene and the place on its axis of the cells of one value.
struct ValuePlace {
    const char* assumption;
    std::string value;
    bool ours;
    const char *scene, *parameter;
    double x;
    std::string axes = {};  ///< of its cells; empty: plain
};

constexpr double middle_speed = 4, slowest_speed = 1;  // rad/s
constexpr double our_step = 1.0 / 60;

std::vector<ValuePlace> places() {
    std::vector<ValuePlace> all;
    for (const int parts : {120, 60, 30, 2})
        all.push_back({"time step", fmt::format("1/{} s", parts), parts == 60, "paper_time_step",
                       "rotation_step", middle_speed / parts});
    for (const double margin : {0.0, 0.05, 0.1, 0.2})
        all.push_back(
            {"margin", fmt::format("{} diagonals", margin), margin == 0, "paper_margin", "margin", margin});
    for (const int bodies : {50, 100, 400, 600})
        all.push_back({"bodies", std::to_string(bodies), false, "paper_body_count", "bodies", 1.0 * bodies});
    for (const int number : {0, 1, 2, 3, 4})
        all.push_back({"population", std::to_string(number + 1), number == 0, "paper_seeds", "population",
                       1.0 * number});
    all.push_back({"tables", "shared by all bodies", false, "paper_time_step", "rotation_step",
                   middle_speed * our_step, "sharing=shared"});
    all.push_back({"asked for", "the verdict alone", false, "paper_time_step", "rotation_step",
                   middle_speed * our_step, "needs=verdict"});
    for (const bool named : {false, true})
        all.push_back({"tolerance at 1 rad/s", named ? "1e-5" : "0", !named, "paper_tolerance",
                       "rotation_step", slowest_speed * our_step, named ? "contact_tolerance=1e-05" : ""});
    return all;
}

const ReportCell* cell_at(const ReportData& data, const ValuePlace& place, int vertices,
                          const std::string& algorithm) {
    const CellKey key{place.scene, paper_shape(vertices), algorithm,
                      place.axes.empty() ? "aos_f64" : "aos_f64 " + place.axes};
    const auto found = in_range(cells_along(data, key, place.parameter), {place.x, place.x});
    return found.empty() ? nullptr : found.front().cell;
}

Evidence not_stored(const ValuePlace& place) {
    return no_evidence(fmt::format("no cells of scene {} at {} {}{} are stored", place.scene, place.parameter,
                                   number_text(place.x), place.axes.empty() ? "" : ", " + place.axes));
}

/// Both were timed in the same rounds as the scene's plain V-Clip, which is `vclip` itself if no axis is
/// varied.
Evidence vclip_over_gjk(const ReportData& data, const ValuePlace& place, int vertices) {
    const ReportCell *vclip = cell_at(data, place, vertices, "vclip"),
                     *gjk = cell_at(data, place, vertices, "gjk");
    if (!vclip || !gjk) return not_stored(place);
    if (place.axes.empty()) return quotient(exact_evidence(1), time_ratio(*gjk, *vclip));
    return quotient(time_of(*vclip), time_of(*gjk));
}

Evidence growth(const ReportData& data, const ValuePlace& place, const std::string& algorithm) {
    const ReportCell *large = cell_at(data, place, 386, algorithm),
                     *small = cell_at(data, place, 38, algorithm);
    return large && small ? quotient(time_of(*large), time_of(*small)) : not_stored(place);
}

enum class VclipIs : std::uint8_t { unknown, faster, slower, undecided };

VclipIs judged(const Evidence& over_gjk) {
    if (!over_gjk.value) return VclipIs::unknown;
    if (over_gjk.high < 1) return VclipIs::faster;
    return over_gjk.low > 1 ? VclipIs::slower : VclipIs::undecided;
}

const char* word_of(VclipIs verdict) {
    constexpr const char* words[] = {"not measured", "faster", "slower", "undecided"};
    return words[static_cast<std::size_t>(verdict)];
}

GridCell evidence_cell(const Evidence& evidence) {
    return evidence.value ? GridCell{evidence_text(evidence, "1")} : missing_cell(evidence.missing);
}

/// "V-Clip is faster at 386 vertices under every value", or under which not.
std::string sentence_of(const std::vector<AssumedValue>& values, std::size_t size) {
    std::string by_verdict[4];
    std::size_t measured = 0;
    for (const AssumedValue& one : values) {
        const VclipIs verdict = judged(one.vclip_over_gjk[size]);
        append(by_verdict[static_cast<std::size_t>(verdict)], one.assumption + " " + one.value);
        measured += verdict != VclipIs::unknown;
    }
    std::string out;
    for (const VclipIs verdict : {VclipIs::faster, VclipIs::slower, VclipIs::undecided}) {
        const std::string& under = by_verdict[static_cast<std::size_t>(verdict)];
        if (under.empty()) continue;
        const bool always = std::ranges::all_of(values, [&](const AssumedValue& one) {
            const VclipIs found = judged(one.vclip_over_gjk[size]);
            return found == verdict || found == VclipIs::unknown;
        });
        append(
            out,
            fmt::format("{} {}", word_of(verdict), always ? "under every value measured" : "(" + under + ")"),
            "; ");
    }
    return measured == 0 ? "" : fmt::format("At {} vertices V-Clip is {}. ", angular_sizes[size], out);
}

}  // namespace

std::vector<AssumedValue> assumed_values(const ReportData& data) {
    std::vector<AssumedValue> values;
    for (const ValuePlace& place : places()) {
        AssumedValue one{place.assumption, place.value, place.ours, {}, {}, {}};
        for (std::size_t size = 0; size < std::size(angular_sizes); ++size)
            one.vclip_over_gjk[size] = vclip_over_gjk(data, place, angular_sizes[size]);
        one.vclip_growth = growth(data, place, "vclip");
        one.gjk_growth = growth(data, place, "gjk");
        values.push_back(std::move(one));
    }
    return values;
}

TextGrid assumptions_grid(const ReportData& data) {
    TextGrid grid{
        "What we had to assume, each varied alone (aos_f64, 4 rad/s except for the tolerance, queries that "
        "start warm; ratios of times with 95 % intervals of this run's rounds)",
        columns_of("assumption|value|ours|#V-Clip / GJK, 8 vertices|#38|#386|V-Clip at 8, 38, 386 is|"
                   "#386 / 38, V-Clip|#386 / 38, GJK"),
        {}};
    for (const AssumedValue& one : assumed_values(data)) {
        std::string verdicts;
        bool any = false;
        for (const Evidence& ratio : one.vclip_over_gjk) {
            append(verdicts, word_of(judged(ratio)));
            any = any || ratio.value;
        }
        if (!any) continue;
        const auto& ratios = one.vclip_over_gjk;
        grid.rows.push_back(grid_row(one.assumption, one.value, one.ours ? "yes" : "",
                                     evidence_cell(ratios[0]), evidence_cell(ratios[1]),
                                     evidence_cell(ratios[2]), verdicts, evidence_cell(one.vclip_growth),
                                     evidence_cell(one.gjk_growth)));
    }
    return grid;
}

std::string assumptions_paragraph(const ReportData& data) {
    const std::vector<AssumedValue> values = assumed_values(data);
    std::string out;
    for (std::size_t size = 0; size < std::size(angular_sizes); ++size) out += sentence_of(values, size);
    return out;
}

}  // namespace edgewise::reports
