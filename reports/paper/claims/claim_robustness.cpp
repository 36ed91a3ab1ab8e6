// SPDX-License-Identifier: MIT
//
// Claims about failures (sections 2 and 4, "Robustness"), and about tolerances, preprocessing and deformation
// (section 4, "Ease of implementation"). The paper's metric is disagreement with Moore-Wilhelms; exact
// arithmetic is next to it. If none of n checks failed, the share of failures is at most 3/n with 95 % (rule
// of three).

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <tuple>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

namespace {

/// 3/n at the paper's 30 000 iterations of one sample point: fewer checks than that show little.
constexpr double least_shown = 1e-4;
/// A metric distinguishes two algorithms if one fails a tenth more often.
constexpr double apart = 1.1;

bool is_subject(const ReportCell& cell) {
    return !cell.is_raw() && (cell.algorithm == "vclip" || cell.algorithm == "gjk");
}

using Rows = std::vector<const ReportCell*>;

Rows subjects(const ReportData& data) {
    Rows rows;
    for (const auto* cells : {&data.cells, &data.from_files})
        for (const ReportCell& cell : *cells)
            if (is_subject(cell)) rows.push_back(&cell);
    return rows;
}

Rows families(const ReportData& data, const std::function<bool(const ReportCell&)>& wanted) {
    Rows rows;
    for (const ReportCell& row : data.stability)
        if (is_subject(row) && wanted(row)) rows.push_back(&row);
    return rows;
}

/// Sums a figure over the rows that have it, with any status: failures of a failed cell count.
Evidence total(const Rows& rows, const store::FigureName& name) {
    if (rows.empty()) return no_evidence("nothing of V-Clip and GJK is stored");
    Evidence all = no_evidence(rows.front()->figure(name).reason);
    for (const ReportCell* row : rows)
        if (const auto value = row->figure(name).value) all = exact_evidence(all.value.value_or(0) + *value);
    return all;
}

/// Cells of one scene, its parameters and one body are asked the same queries, whatever their algorithm,
/// table type and axes, so they are one sample. Returns the largest count of any such cell, summed over
/// scenes.
Evidence independent(const Rows& rows, const store::FigureName& name) {
    std::map<std::tuple<std::string, std::string, std::string, std::uint64_t>, double> most;
    for (const ReportCell* row : rows)
        if (const auto value = row->figure(name).value) {
            double& of = most[{row->scene, row->scene_parameters, row->shape, row->seed}];
            of = std::max(of, *value);
        }
    Evidence all = total(rows, name);  // for its reason where there is none
    if (!all.value) return all;
    double queries = 0;
    for (const auto& [asked, count] : most) queries += count;
    return exact_evidence(queries);
}

/// Largest share of independent queries at which a cell may have failed; if none failed, up to the rule of
/// three.
Evidence bounded_share(const Evidence& failures, const Evidence& queries) {
    const Evidence share = quotient(failures, queries);
    if (!share.value || *share.value > 0) return share;
    return interval_evidence(0, 0, 3 / *queries.value);
}

std::vector<ClaimPart> no_failures(const Rows& rows, const store::FigureName& failed,
                                   const store::FigureName& checked) {
    const Evidence failures = total(rows, failed), queries = independent(rows, checked);
    return {{"failures", failures, at_most(0), "answers"},
            {"answers checked", total(rows, checked), only_shown(), "answers"},
            {"independent queries", queries, only_shown(), "queries"},
            {"share of those", bounded_share(failures, queries), at_most(least_shown)}};
}

Claim judge_exact(const ReportData& data) {
    const Rows rows = subjects(data);
    std::vector<ClaimPart> parts = no_failures(rows, "error.wrong_verdicts", "error.checked");
    double failed = 0;
    for (const ReportCell* row : rows) failed += row->failed();
    parts.push_back({"failed cells", exact_evidence(failed), at_most(0), "cells"});
    return judge_claim("zero_failures_exact", parts);
}

Claim judge_superfluous(const ReportData& data) {
    const auto share = [&](const std::string& algorithm) {
        const Rows rows = families(data, [&](const ReportCell& row) {
            return row.algorithm == algorithm && row.table == "aos_f64";
        });
        return quotient(
            no_less_than(total(rows, store::FigureName("stability.failures_at_{tolerance}").of("0e+00")), 1),
            total(rows, "stability.cases"));
    };
    const Evidence vclip = share("vclip"), gjk = share("gjk");
    return judge_claim(
        "robustness_metric_tells_apart",
        {{"worse over better", quotient(largest({vclip, gjk}), smallest({vclip, gjk})), at_least(apart)},
         {"V-Clip's share", vclip, only_shown()},
         {"GJK's share", gjk, only_shown()}});
}

}  // namespace

std::vector<Claim> robustness_claims(const ReportData& data) {
    const Rows rows = subjects(data), hard = families(data, [](const ReportCell&) { return true; });
    return {judge_claim("zero_failures_control", no_failures(rows, "error.control_disagreements_outside_band",
                                                             "error.control_checked")),
            judge_exact(data),
            judge_claim("zero_failures_hard_families",
                        no_failures(hard, "stability.wrong_outside_band", "stability.cases")),
            judge_superfluous(data)};
}

namespace {

/// "No difficulties": one verdict in a hundred more than at the best tolerance.
constexpr double harmless = 0.01;
/// A body has one test per step in figure 5 (300 pairs, 600 bodies): a hundred tests are more than a second
/// of its life at 60 steps per second.
constexpr double substantial = 100;
/// A burden that everyone would notice.
constexpr double twice = 2;

using Families = std::vector<std::string>;
const Families random_pairs = {"random_fuzz", "cubes_random"}, all_families;

bool is_among(const std::string& family, const Families& wanted) {
    return wanted.empty() || std::ranges::find(wanted, family) != wanted.end();
}

/// Share of verdicts that are wrong at a tolerance, both algorithms and the families together.
Evidence wrong_share(const ReportData& data, const std::string& table, const Families& wanted,
                     const std::string& at) {
    double failures = 0, cases = 0;
    std::string why = "no stability run of such families on " + table + " is stored";
    for (const ReportCell& row : data.stability) {
        if (row.table != table || !is_among(row.shape, wanted)) continue;
        const measure::Figure failed =
            row.figure(store::FigureName("stability.failures_at_{tolerance}").of(at));
        const measure::Figure asked = row.figure("stability.cases");
        if (!failed.value || !asked.value) {
            why = failed.value ? asked.reason : failed.reason;
            continue;
        }
        failures += *failed.value;
        cases += *asked.value;
    }
    return cases > 0 ? exact_evidence(failures / cases) : no_evidence(why);
}

/// Beyond the best of all tolerances that the stability run tries.
Evidence excess(const ReportData& data, const std::string& table, const Families& wanted,
                const std::string& at) {
    const Evidence here = wrong_share(data, table, wanted, at);
    if (!here.value) return here;
    double best = *here.value;
    for (const char* other :
         {"0e+00", "1e-16", "1e-14", "1e-12", "1e-10", "1e-08", "1e-06", "1e-05", "1e-03"})
        if (const Evidence share = wrong_share(data, table, wanted, other); share.value)
            best = std::min(best, *share.value);
    return exact_evidence(*here.value - best);
}

Claim judge_tolerance(const ReportData& data) {
    return judge_claim(
        "tolerance_1e5_harmless",
        {{"excess, random pairs", excess(data, "aos_f64", random_pairs, "1e-05"), at_most(harmless)},
         {"excess, all families", excess(data, "aos_f64", all_families, "1e-05"), only_shown()}});
}

Evidence table_time(const ReportData& data, const std::string& algorithm, const store::FigureName& name) {
    return figure_of(data, {"paper_angular_386", "", algorithm}, name);
}

Evidence queries_to_build(const ReportData& data, const std::string& algorithm) {
    return quotient(table_time(data, algorithm, "build.build_ns"), slowest_time(data, 386, algorithm));
}

/// Making a table ready again and asking once, V-Clip's time over GJK's.
ClaimPart burden(const ReportData& data, const store::FigureName& made, const WantedBand& wanted) {
    const auto both = [&](const std::string& algorithm) {
        return sum(table_time(data, algorithm, made), slowest_time(data, 386, algorithm));
    };
    return {"V-Clip over GJK", quotient(both("vclip"), both("gjk")), wanted};
}

Claim judge_deforming(const ReportData& data) {
    return judge_claim("deformation_favours_gjk",
                       {burden(data, "build.refit_ns", more_than(1)),
                        {"V-Clip's refit", table_time(data, "vclip", "build.refit_ns"), only_shown(), "ns"},
                        {"GJK's refit", table_time(data, "gjk", "build.refit_ns"), only_shown(), "ns"}});
}

/// A fracture makes bodies of another topology: their tables are built, not refitted.
Claim judge_fracturing(const ReportData& data) {
    return judge_claim("fracturing_favours_gjk",
                       {burden(data, "build.build_ns", at_least(twice)),
                        {"V-Clip's build", table_time(data, "vclip", "build.build_ns"), only_shown(), "ns"},
                        {"GJK's build", table_time(data, "gjk", "build.build_ns"), only_shown(), "ns"}});
}

}  // namespace

std::vector<Claim> ease_claims(const ReportData& data) {
    return {judge_tolerance(data),
            judge_claim("preprocessing_substantial",
                        {{"V-Clip", queries_to_build(data, "vclip"), at_least(substantial)}}),
            judge_deforming(data), judge_fracturing(data)};
}

}  // namespace edgewise::reports
