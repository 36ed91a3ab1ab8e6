// SPDX-License-Identifier: MIT
//
// Claims about what V-Clip's tables take (sections 4, "Scalability" and "Ease of implementation", and 5).
#include "edgewise/reports/paper/claims/claim_groups.hpp"

namespace edgewise::reports {

namespace {

/// A slope that rounds to the paper's number.
constexpr double paper_edge_low = 167.5, paper_edge_high = 168.5;
/// "Halves": to one per cent.
constexpr double half_low = 1.98, half_high = 2.02;
/// "Each additional edge": small bodies share fixed costs among fewer edges, some per cent.
constexpr double most_spread = 1.1;
/// "Significant": twice as much is beyond any choice of layout.
constexpr double significant = 2;
/// "Hundreds of such primitives", and what a PC of 2000 commonly had: 64 MiB.
constexpr double hundreds = 300, memory_of_2000 = 64.0 * 1024 * 1024;

Evidence slope(const ReportData& data, const std::string& table) {
    return figure_of(data, {"", "sphere386", "vclip", table}, "bytes.paper_bytes_per_edge");
}

const char* const no_sizes = "no cells of scene paper_complexity, vclip on aos_f64, are stored";

Claim judge_linear(const ReportData& data) {
    const auto sizes = values_of(
        curve_of(cells_along(data, vclip_key("paper_complexity"), "vertices"), "bytes.total_bytes_per_edge"));
    return judge_claim("memory_linear_in_edges",
                       {{"largest over smallest", quotient(largest(sizes, no_sizes), smallest(sizes)),
                         at_most(most_spread)}});
}

}  // namespace

std::vector<Claim> memory_claims(const ReportData& data) {
    const Evidence in_double = slope(data, "aos_f64"), in_single = slope(data, "aos_f32");
    const Evidence vclip = figure_of(data, vclip_key("", "sphere386"), "bytes.table_bytes");
    const Evidence gjk = figure_of(data, gjk_key("", "sphere386"), "bytes.table_bytes");
    Evidence many = vclip;
    if (many.value) many = exact_evidence(hundreds * *many.value);
    return {judge_claim("bytes_per_edge_double",
                        {{"aos_f64", in_double, between(paper_edge_low, paper_edge_high)}}),
            judge_claim("bytes_halved_in_single",
                        {{"double over single", quotient(in_double, in_single), between(half_low, half_high)},
                         {"single", in_single, only_shown(), "B/edge"}}),
            judge_linear(data),
            judge_claim("memory_overhead_of_vclip",
                        {{"V-Clip over GJK", quotient(vclip, gjk), at_least(significant)},
                         {"V-Clip", vclip, only_shown(), "B"},
                         {"GJK", gjk, only_shown(), "B"}}),
            judge_claim("hundreds_fill_memory", {{"300 tables", many, at_least(memory_of_2000)}})};
}

}  // namespace edgewise::reports
