// SPDX-License-Identifier: MIT
//
// Claims about memory that is too small (section 4, "Scalability": "memory swapping"): the rows of the paging
// run, real page faults under limits.
#include <fmt/core.h>

#include "edgewise/reports/paper/claims/claim_groups.hpp"

namespace edgewise::reports {

namespace {

/// A limit that is "too small": half of what V-Clip touches, so that no choice of pages can keep it.
constexpr double part_of_touched = 0.5;
/// "Large amounts": a fault every twentieth query.
constexpr double large_amounts = 0.05;
/// GJK "performs as it did": a tenth of V-Clip's faults at most.
constexpr double spared_share = 0.1;
/// The axis of figure 8 is 12 times that of figure 7.
constexpr double slowed = 12;

const ReportCell* row_of_run(const ReportData& data, const std::string& algorithm) {
    for (const ReportCell& row : data.paging)
        if (row.algorithm == algorithm && row.table == "aos_f64" && row.shape == "sphere386") return &row;
    return nullptr;
}

Evidence at(const ReportCell& row, const store::FigureName& name, int i) {
    return figure_of(row, name.of(std::to_string(i)));
}

/// The number of the wanted limit: the largest that is below `bound`, where 0 bytes mean no limit at all; -1
/// when there is none.
int largest_limit(const ReportCell& row, double bound) {
    int best = -1;
    double most = -1;
    for (int i = 0;; ++i) {
        const Evidence limit = at(row, "paging.limit_bytes.{limit}", i);
        if (!limit.value) return best;
        const double bytes = *limit.value > 0 ? *limit.value : 1e300;
        if (bytes < bound && bytes > most) best = i, most = bytes;
    }
}

/// Of V-Clip's row: the limit that is too small.
Evidence tight_limit(const ReportData& data) {
    const ReportCell* row = row_of_run(data, "vclip");
    if (!row) return no_evidence("no paging run of vclip on aos_f64, sphere386, is stored");
    const Evidence touched = figure_of(*row, "paging.touched_bytes");
    if (!touched.value) return touched;
    const int i = largest_limit(*row, part_of_touched * *touched.value);
    if (i < 0) return no_evidence("no limit is below half of what V-Clip touches");
    return at(*row, "paging.limit_bytes.{limit}", i);
}

/// A figure of an algorithm's row at V-Clip's tight limit.
Evidence when_tight(const ReportData& data, const std::string& algorithm, const store::FigureName& name) {
    const Evidence limit = tight_limit(data);
    if (!limit.value) return limit;
    const ReportCell* row = row_of_run(data, algorithm);
    if (!row)
        return no_evidence(fmt::format("no paging run of {} on aos_f64, sphere386, is stored", algorithm));
    // Its own limits may all be smaller; with more memory it faults no more often.
    const int i = largest_limit(*row, *limit.value + 1);
    if (i < 0) return no_evidence(fmt::format("no row of {} has V-Clip's limit or a smaller one", algorithm));
    return at(*row, name, i);
}

Evidence time_at_ease(const ReportData& data) {
    const ReportCell* row = row_of_run(data, "vclip");
    if (!row) return no_evidence("no paging run of vclip on aos_f64, sphere386, is stored");
    const int i = largest_limit(*row, 1e301);
    return i < 0 ? no_evidence("the paging run has no limit") : at(*row, "paging.us_per_query.{limit}", i);
}

}  // namespace

std::vector<Claim> paging_claims(const ReportData& data) {
    const Evidence vclip = when_tight(data, "vclip", "paging.faults_per_query.{limit}");
    const Evidence ratio = quotient(when_tight(data, "gjk", "paging.faults_per_query.{limit}"), vclip);
    const Evidence slower =
        quotient(when_tight(data, "vclip", "paging.us_per_query.{limit}"), time_at_ease(data));
    return {judge_claim("memory_too_small_swaps", {{"V-Clip", vclip, at_least(large_amounts)},
                                                   {"limit", tight_limit(data), only_shown(), "B"}}),
            judge_claim("swapping_spares_gjk", {{"GJK over V-Clip", ratio, at_most(spared_share)}}),
            judge_claim("swapping_explains_figure_8",
                        {{"with too little memory over with enough", slower, at_least(slowed)}})};
}

}  // namespace edgewise::reports
