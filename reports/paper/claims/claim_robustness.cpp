// SPDX-License-Identifier: MIT
//
// Claims about failures (sections 2 and 4, "Robustness"). The paper's metric is disagreement with
// Moore-Wilhelms; exact arithmetic stands beside it. Where none of n checks failed, the share of failures is
// at most 3/n with 95 % (rule of three).
#include <functional>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

namespace {

/// 3/n at the paper's 30 000 iterations of one sample point: fewer checks than that show little.
constexpr double least_shown = 1e-4;
/// A metric tells two algorithms apart when one fails a tenth more often.
constexpr double apart = 1.1;

bool is_subject(const ReportCell& cell) { return cell.algorithm == "vclip" || cell.algorithm == "gjk"; }

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

/// A share; where it is 0, up to the rule of three.
Evidence bounded_share(const Evidence& failures, const Evidence& checks) {
    const Evidence share = quotient(failures, checks);
    if (!share.value || *share.value > 0) return share;
    return interval_evidence(0, 0, 3 / *checks.value);
}

std::vector<ClaimPart> no_failures(const Evidence& failures, const Evidence& checks) {
    return {{"failures", failures, at_most(0), "queries"},
            {"checked", checks, only_shown(), "queries"},
            {"share", bounded_share(failures, checks), at_most(least_shown)}};
}

Claim judge_exact(const ReportData& data) {
    const Rows rows = subjects(data);
    std::vector<ClaimPart> parts =
        no_failures(total(rows, "error.wrong_verdicts"), total(rows, "error.checked"));
    double failed = 0;
    for (const ReportCell* row : rows) failed += row->status == "failed";
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

Claim judge_wrong_points(const Rows& rows) {
    const Evidence points = total(rows, "stability.errors_beyond"),
                   verdicts = total(rows, "stability.wrong_outside_band");
    // Of none and none nothing is the more frequent.
    const WantedBand more = more_than(verdicts.value.value_or(0));
    return judge_claim("wrong_points_before_wrong_verdicts",
                       {{"wrong points", points, {more.low, more.high, "more than wrong verdicts"}},
                        {"wrong verdicts", verdicts, only_shown()}});
}

}  // namespace

std::vector<Claim> robustness_claims(const ReportData& data) {
    const Rows rows = subjects(data), hard = families(data, [](const ReportCell&) { return true; });
    return {
        judge_claim("zero_failures_control",
                    no_failures(total(rows, "error.control_disagreements_outside_band"),
                                total(rows, "error.control_checked"))),
        judge_exact(data),
        judge_claim("zero_failures_hard_families",
                    no_failures(total(hard, "stability.wrong_outside_band"), total(hard, "stability.cases"))),
        judge_wrong_points(hard), judge_superfluous(data)};
}

}  // namespace edgewise::reports
