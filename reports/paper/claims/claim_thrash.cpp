// SPDX-License-Identifier: MIT
//
// Claims about caches (sections 4, "Scalability", and 5): 300 bodies with tables of their own, through models
// of machines of the paper's years, and on the machine that measured.
#include <utility>

#include "edgewise/reports/paper/claims/claim_cells.hpp"

namespace edgewise::reports {

namespace {

/// "Considerable": misses at least double.
constexpr double considerable = 2;
/// What goes when its cause goes: at least half.
constexpr double cause_gone = 0.5;
/// Queries are traced by the thousand: fewer misses than this are none, and a ratio to them is no number.
constexpr double least_misses = 0.001;
constexpr const char* machines[] = {"pentium3_coppermine", "pentium2_deschutes", "athlon_thunderbird"};

/// Of one of the scenes paper_thrash_*, geometric mean over the speeds in a reading's range of figure 8.
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
