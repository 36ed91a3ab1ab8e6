// SPDX-License-Identifier: MIT
//
// Claims about failures (sections 2 and 4, "Robustness"). The paper's metric is disagreement with
// Moore-Wilhelms; exact arithmetic stands beside it. Where none of n checks failed, the share of failures is
// at most 3/n with 95 % (rule of three).
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
/// A metric tells two algorithms apart when one fails a tenth more often.
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

/// Over the rows that have it, whatever their status: a failed cell's failures count.
Evidence total(const Rows& rows, const store::FigureName& name) {
    if (rows.empty()) return no_evidence("nothing of V-Clip and GJK is stored");
    Evidence all = no_evidence(rows.front()->figure(name).reason);
    for (const ReportCell* row : rows)
        if (const auto value = row->figure(name).value) all = exact_evidence(all.value.value_or(0) + *value);
    return all;
}

/// Cells of one scene, its parameters and one body are asked the same queries, whatever their algorithm,
/// table type and axes: a sample of them, and not so many. The most of any such cell, all scenes together.
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

/// Of independent queries that some cell failed at, at most; where none did, up to the rule of three.
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

}  // namespace edgewise::reports
