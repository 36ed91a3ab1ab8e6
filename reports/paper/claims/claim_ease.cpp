// SPDX-License-Identifier: MIT
//
// Claims about tolerances, preprocessing and deformation (section 4, "Ease of implementation").
#include <algorithm>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

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
