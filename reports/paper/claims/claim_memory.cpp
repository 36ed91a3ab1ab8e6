// SPDX-License-Identifier: MIT
//
// Claims about what V-Clip's tables take (sections 4, "Scalability" and "Ease of implementation", and 5);
// about memory that is too small for them (section 4, "memory swapping"): the rows of the paging run, real
// page faults under limits; and about caches (sections 4 and 5): 300 bodies with tables of their own, through
// models of machines of the paper's years, and on the machine that measured.

#include <fmt/core.h>

#include <utility>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

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

/// A limit that is "too small": half of what V-Clip touches, so that no choice of pages can keep it.
constexpr double part_of_touched = 0.5;
/// GJK "performs as it did": a tenth of V-Clip's faults at most.
constexpr double spared_share = 0.1;
/// The axis of figure 8 is 12 times that of figure 7.
constexpr double slowed = 12;

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

const ReportCell* row_of_run(const ReportData& data, const std::string& algorithm) {
    for (const ReportCell& row : data.paging)
        if (row.algorithm == algorithm && row.table == "aos_f64" && row.shape == "sphere386") return &row;
    return nullptr;
}

Evidence no_run(const std::string& algorithm) {
    return no_evidence(fmt::format("no paging run of {} on aos_f64, sphere386, is stored", algorithm));
}

/// The number of the wanted limit: the largest that is below `bound`, where 0 bytes mean no limit at all; -1
/// when there is none.
int largest_limit(const ReportCell& row, double bound) {
    int best = -1;
    double most = -1;
    for (int i = 0;; ++i) {
        const Evidence limit =
            figure_of(row, store::FigureName("paging.limit_bytes.{limit}").of(std::to_string(i)));
        if (!limit.value) return best;
        const double bytes = *limit.value > 0 ? *limit.value : 1e300;
        if (bytes < bound && bytes > most) best = i, most = bytes;
    }
}

/// A figure of an algorithm's row at its largest limit below `bound`.
Evidence at_limit(const ReportData& data, const std::string& algorithm, double bound,
                  const store::FigureName& name, const std::string& when_none) {
    const ReportCell* row = row_of_run(data, algorithm);
    if (!row) return no_run(algorithm);
    const int i = largest_limit(*row, bound);
    return i < 0 ? no_evidence(when_none) : figure_of(*row, name.of(std::to_string(i)));
}

/// Returns the limit of V-Clip's row that is too small.
Evidence tight_limit(const ReportData& data) {
    const ReportCell* row = row_of_run(data, "vclip");
    const Evidence touched = row ? figure_of(*row, "paging.touched_bytes") : no_run("vclip");
    if (!touched.value) return touched;
    return at_limit(data, "vclip", part_of_touched * *touched.value, "paging.limit_bytes.{limit}",
                    "no limit is below half of what V-Clip touches");
}

/// A figure of an algorithm's row at V-Clip's tight limit. Its own limits may all be smaller; with more
/// memory it faults no more often.
Evidence when_tight(const ReportData& data, const std::string& algorithm, const store::FigureName& name) {
    const Evidence limit = tight_limit(data);
    if (!limit.value) return limit;
    return at_limit(data, algorithm, *limit.value + 1, name,
                    fmt::format("no row of {} has V-Clip's limit or a smaller one", algorithm));
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

std::vector<Claim> paging_claims(const ReportData& data) {
    const Evidence vclip = when_tight(data, "vclip", "paging.faults_per_query.{limit}");
    const Evidence ratio = quotient(when_tight(data, "gjk", "paging.faults_per_query.{limit}"), vclip);
    const store::FigureName time("paging.us_per_query.{limit}");
    const Evidence at_ease = at_limit(data, "vclip", 1e301, time, "the paging run has no limit");
    const Evidence slower = quotient(when_tight(data, "vclip", time), at_ease);
    return {judge_claim("swapping_spares_gjk", {{"GJK over V-Clip", ratio, at_most(spared_share)},
                                                {"V-Clip's", vclip, only_shown(), "faults/query"},
                                                {"limit", tight_limit(data), only_shown(), "B"}}),
            judge_claim("swapping_explains_figure_8",
                        {{"with too little memory over with enough", slower, at_least(slowed)}})};
}

namespace {

/// "Considerable": misses at least double.
constexpr double considerable = 2;
/// What goes when its cause goes: at least half.
constexpr double cause_gone = 0.5;
/// Queries are traced by the thousand: fewer misses than this are none, and a ratio to them is no number.
constexpr double least_misses = 0.001;
constexpr const char* machines[] = {"pentium3_coppermine", "pentium2_deschutes", "athlon_thunderbird"};

/// Geometric mean of a figure in one of the scenes paper_thrash_*, over the speeds in a reading's range of
/// figure 8.
Evidence thrash_mean(const ReportData& data, int vertices, const std::string& algorithm,
                     const std::string& table, const TimeStepReading& reading,
                     const store::FigureName& figure) {
    const CellKey key{"paper_thrash_" + std::to_string(vertices), "", algorithm, table};
    const CurveRange steps = in_steps(figures_7_and_8_speeds, reading);
    std::vector<Evidence> values;
    for (const CurvePoint& point : curve_of(in_range(cells_along(data, key, "rotation_step"), steps), figure))
        values.push_back(no_less_than(point.y, least_misses));
    if (values.empty())
        return no_evidence("no cell of " + key.scene + ", " + algorithm + " on " + table + ", " +
                           reading.name + " is stored");
    return geometric_mean(values);
}

Evidence misses(const ReportData& data, int vertices, const std::string& algorithm,
                const TimeStepReading& reading, const std::string& machine,
                const std::string& table = "aos_f64") {
    return thrash_mean(data, vertices, algorithm, table, reading,
                       store::level_misses.of(machine, "L2").warm());
}

/// V-Clip's misses at 386 vertices over those of an algorithm at a size.
Claim judge_misses(const ReportData& data, const std::string& id, int vertices,
                   const std::string& algorithm) {
    return both_readings(id, [&](const TimeStepReading& reading) {
        PartList parts;
        for (const char* machine : machines)
            parts.push_back({machine,
                             quotient(misses(data, 386, "vclip", reading, machine),
                                      misses(data, vertices, algorithm, reading, machine)),
                             at_least(considerable)});
        return parts;
    });
}

Claim judge_cause(const ReportData& data) {
    return both_readings("thrash_caused_by_tables", [&](const TimeStepReading& reading) {
        const auto of = [&](const char* table) {
            return misses(data, 386, "vclip", reading, machines[0], table);
        };
        const Evidence plain = of("aos_f64");
        return PartList{{"shared tables", quotient(of("aos_f64 sharing=shared"), plain), at_most(cause_gone)},
                        {"lean tables", quotient(of("lean_f64"), plain), at_most(cause_gone)},
                        {"misses with it", plain, only_shown(), "misses"}};
    });
}

Claim judge_locality(const ReportData& data) {
    return both_readings("more_lines_than_gjk", [&](const TimeStepReading& reading) {
        const auto lines = [&](const char* algorithm) {
            return thrash_mean(data, 386, algorithm, "aos_f64", reading,
                               store::reuse_names[0].per_query.warm());
        };
        return PartList{{"V-Clip over GJK", quotient(lines("vclip"), lines("gjk")), more_than(1)}};
    });
}

}  // namespace

std::vector<Claim> thrash_claims(const ReportData& data) {
    return {judge_locality(data), judge_misses(data, "cache_misses_grow_at_386", 38, "vclip"),
            judge_misses(data, "cache_misses_spare_gjk", 386, "gjk"), judge_cause(data)};
}

}  // namespace edgewise::reports
