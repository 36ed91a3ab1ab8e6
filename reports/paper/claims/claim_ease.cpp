// SPDX-License-Identifier: MIT
//
// Claims about tolerances, preprocessing and deformation (section 4, "Ease of implementation").
#include <algorithm>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

namespace {

/// "No difficulties": one verdict in a hundred more than at the best tolerance.
constexpr double harmless = 0.01;
/// "Numerical problems do arise": one verdict in a thousand more.
constexpr double trouble = 0.001;
/// A body has one test per step in figure 5 (300 pairs, 600 bodies): a hundred tests are more than a second
/// of its life at 60 steps per second.
constexpr double substantial = 100;
/// "None of these drawbacks": less than one query's time.
constexpr double none_of_it = 1;

using Families = std::vector<std::string>;
const Families random_pairs = {"random_fuzz", "cubes_random"}, all_families;

bool is_among(const std::string& family, const Families& wanted) {
    return wanted.empty() || std::find(wanted.begin(), wanted.end(), family) != wanted.end();
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

Claim judge_limits(const ReportData& data) {
    return judge_claim(
        "tolerance_at_precision_fails",
        {{"excess at 1e-16, double", excess(data, "aos_f64", all_families, "1e-16"), at_least(trouble)},
         {"excess at 1e-8, single", excess(data, "aos_f32", all_families, "1e-08"), at_least(trouble)}});
}

Evidence table_time(const ReportData& data, const std::string& algorithm, const store::FigureName& name) {
    return figure_of(data, {"paper_angular_386", "", algorithm}, name);
}

Evidence queries_to_build(const ReportData& data, const std::string& algorithm) {
    return quotient(table_time(data, algorithm, "build.build_ns"), slowest_time(data, 386, algorithm));
}

Claim judge_deforming(const ReportData& data) {
    const auto both = [&](const std::string& algorithm) {
        return sum(table_time(data, algorithm, "build.refit_ns"), slowest_time(data, 386, algorithm));
    };
    return judge_claim("deformation_favours_gjk",
                       {{"V-Clip over GJK", quotient(both("vclip"), both("gjk")), more_than(1)},
                        {"V-Clip's refit", table_time(data, "vclip", "build.refit_ns"), only_shown(), "ns"},
                        {"GJK's refit", table_time(data, "gjk", "build.refit_ns"), only_shown(), "ns"}});
}

}  // namespace

std::vector<Claim> ease_claims(const ReportData& data) {
    return {judge_tolerance(data), judge_limits(data),
            judge_claim("preprocessing_substantial",
                        {{"V-Clip", queries_to_build(data, "vclip"), at_least(substantial)}}),
            judge_claim("gjk_needs_no_preprocessing",
                        {{"GJK", queries_to_build(data, "gjk"), at_most(none_of_it)}}),
            judge_deforming(data)};
}

}  // namespace edgewise::reports
