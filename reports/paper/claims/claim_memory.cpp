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

constexpr ClaimText bytes_double{
    "bytes_per_edge_double",
    "4 Scalability",
    "In double precision every additional edge takes 168 bytes of V-Clip's feature data.",
    "168 B",
    "B/edge",
    "The slope of planes, direction and length, and vertex coordinates over edges, of tables that were "
    "built; "
    "within half a byte.",
    true};
constexpr ClaimText bytes_single{"bytes_halved_in_single",
                                 "4 Scalability",
                                 "Single precision halves the overhead of an edge.",
                                 "half of 168 B: 84 B",
                                 "1",
                                 "The same slope in double over that in single; to 1 %.",
                                 true};
constexpr ClaimText bytes_linear{
    "memory_linear_in_edges",
    "5",
    "Memory grows by the same amount with every edge, however large the model.",
    "168 B for every edge",
    "1",
    "All bytes of V-Clip's table an edge, 8 to 24578 vertices: largest over smallest.",
    true};
constexpr ClaimText overhead{"memory_overhead_of_vclip",
                             "4 Scalability",
                             "V-Clip's data structures take significantly more memory than GJK's.",
                             "\"significant\"",
                             "1",
                             "V-Clip's table over GJK's in the same layout, 386 vertices.",
                             true};
constexpr ClaimText all_memory{
    "hundreds_fill_memory",
    "4 Scalability",
    "Hundreds of bodies of 386 vertices take all available memory.",
    "\"all available memory\"",
    "B",
    "300 of V-Clip's tables at 386 vertices against 64 MiB, which a PC of 2000 commonly had; the paper names "
    "neither its machine nor the number.",
    true};

Evidence slope(const ReportData& data, const std::string& table) {
    return figure_of(data, {"", "sphere386", "vclip", table}, "bytes.paper_bytes_per_edge");
}

const char* const no_sizes = "no cells of scene paper_complexity, vclip on aos_f64, are stored";

Claim judge_linear(const ReportData& data) {
    const auto sizes = values_of(
        curve_of(cells_along(data, vclip_key("paper_complexity"), "vertices"), "bytes.total_bytes_per_edge"));
    return judge_claim(bytes_linear,
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
    return {judge_claim(bytes_double, {{"aos_f64", in_double, between(paper_edge_low, paper_edge_high)}}),
            judge_claim(bytes_single,
                        {{"double over single", quotient(in_double, in_single), between(half_low, half_high)},
                         {"single", in_single, only_shown(), "B/edge"}}),
            judge_linear(data),
            judge_claim(overhead, {{"V-Clip over GJK", quotient(vclip, gjk), at_least(significant)},
                                   {"V-Clip", vclip, only_shown(), "B"},
                                   {"GJK", gjk, only_shown(), "B"}}),
            judge_claim(all_memory, {{"300 tables", many, at_least(memory_of_2000)}})};
}

}  // namespace edgewise::reports
