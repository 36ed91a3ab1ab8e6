// SPDX-License-Identifier: MIT
//
// Claims about caches (sections 4, "Scalability", and 5): 300 bodies with tables of their own, through models
// of machines of the paper's years, and on the machine that measured.
#include <utility>

#include "edgewise/reports/paper/claims/claim_groups.hpp"

namespace edgewise::reports {

namespace {

/// "Considerable": misses at least double.
constexpr double considerable = 2;
/// What goes when its cause goes: at least half.
constexpr double cause_gone = 0.5;
/// 256 KiB, the second level of a Pentium III Coppermine and an Athlon Thunderbird; what "fast access
/// on-board cache" was in 2001.
constexpr double cache_of_2001 = 256.0 * 1024;
/// Queries are traced by the thousand: fewer misses than this are none, and a ratio to them is no number.
constexpr double least_misses = 0.001;
/// Slower by half: beyond what noise of a shared machine does to a median.
constexpr double slower_here = 1.5;

constexpr ClaimText grows{
    "cache_misses_grow_at_386",
    "5",
    "With large models V-Clip constantly thrashes the cache of most processors.",
    "\"constantly\", 386 against 38 vertices",
    "1",
    "V-Clip's modelled misses a query in the second level, 386 vertices over 38, in paper_thrash_* over the "
    "range of figure 8; on each of three machines of the paper's years.",
    true};
constexpr ClaimText spared{"cache_misses_spare_gjk",
                           "5",
                           "V-Clip's data structures thrash the cache where GJK's do not.",
                           "GJK as with 8 and 38 vertices",
                           "1",
                           "V-Clip's modelled misses a query in the second level over GJK's, at 386 "
                           "vertices; on each of three machines.",
                           true};
constexpr ClaimText cause{
    "thrash_caused_by_tables",
    "5",
    "The data structures are what makes the difference as models grow.",
    "\"caused by the data structures\"",
    "1",
    "V-Clip's modelled misses in the second level of a Pentium III at 386 vertices, without what is blamed "
    "over "
    "with it: one table for all bodies, and tables without stored planes (lean_f64); half or less of them is "
    "left.",
    true};
constexpr ClaimText knee{
    "working_set_beyond_cache",
    "4 Scalability",
    "V-Clip has a large footprint at 386 vertices: more than a cache of 2001 holds.",
    "\"large foot-print\"",
    "B",
    "The knee of V-Clip's misses over cache size in paper_thrash_386 over the range of figure "
    "8, against 256 KiB.",
    true};
constexpr ClaimText locality{
    "more_lines_than_gjk",
    "4 Scalability",
    "V-Clip's locality of reference is poor: a query touches more memory than GJK's.",
    "\"poor locality\"",
    "1",
    "Distinct cache lines a query at 386 vertices in paper_thrash_386, V-Clip's over GJK's.",
    true};
constexpr ClaimText here{
    "thrash_measured_today",
    "5",
    "Large models in great number still thrash the caches of this machine.",
    "\"most modern processors\"",
    "1",
    "V-Clip's time at the most bodies in paper_caches_here over that at the fewest; slower by half.",
    false};

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
                           reading.words + " is stored");
    return geometric_mean(values);
}

Evidence misses(const ReportData& data, int vertices, const std::string& algorithm,
                const TimeStepReading& reading, const std::string& machine,
                const std::string& table = "aos_f64") {
    return thrash_mean(data, vertices, algorithm, table, reading, store::level_misses.of(machine, "L2"));
}

using PartList = std::vector<ClaimPart>;

template <class Parts>
Claim both_readings(const ClaimText& text, const Parts& parts) {
    return judge_readings(text, parts(reading_60th), parts(reading_half));
}

Claim judge_grows(const ReportData& data) {
    return both_readings(grows, [&](const TimeStepReading& reading) {
        PartList parts;
        for (const char* machine : machines)
            parts.push_back({machine,
                             quotient(misses(data, 386, "vclip", reading, machine),
                                      misses(data, 38, "vclip", reading, machine)),
                             at_least(considerable)});
        return parts;
    });
}

Claim judge_spared(const ReportData& data) {
    return both_readings(spared, [&](const TimeStepReading& reading) {
        PartList parts;
        for (const char* machine : machines)
            parts.push_back({machine,
                             quotient(misses(data, 386, "vclip", reading, machine),
                                      misses(data, 386, "gjk", reading, machine)),
                             at_least(considerable)});
        return parts;
    });
}

Claim judge_cause(const ReportData& data) {
    return both_readings(cause, [&](const TimeStepReading& reading) {
        const auto of = [&](const char* table) {
            return misses(data, 386, "vclip", reading, machines[0], table);
        };
        const Evidence plain = of("aos_f64");
        return PartList{{"shared tables", quotient(of("aos_f64 sharing=shared"), plain), at_most(cause_gone)},
                        {"lean tables", quotient(of("lean_f64"), plain), at_most(cause_gone)},
                        {"misses with it", plain, only_shown(), "misses"}};
    });
}

Claim judge_knee(const ReportData& data) {
    return both_readings(knee, [&](const TimeStepReading& reading) {
        return PartList{{"knee", thrash_mean(data, 386, "vclip", "aos_f64", reading, "reuse.line_knee_bytes"),
                         more_than(cache_of_2001)}};
    });
}

Claim judge_locality(const ReportData& data) {
    return both_readings(locality, [&](const TimeStepReading& reading) {
        const auto lines = [&](const char* algorithm) {
            return thrash_mean(data, 386, algorithm, "aos_f64", reading, "reuse.lines_per_query");
        };
        return PartList{{"V-Clip over GJK", quotient(lines("vclip"), lines("gjk")), more_than(1)}};
    });
}

Claim judge_here(const ReportData& data) {
    const auto curve = time_curve(cells_along(data, vclip_key("paper_caches_here"), "bodies"));
    const Evidence growth = curve.size() < 2
                                ? no_evidence("paper_caches_here has fewer than two numbers of bodies")
                                : quotient(curve.back().y, curve.front().y);
    return judge_claim(here, {{"most over fewest bodies", growth, at_least(slower_here)}});
}

}  // namespace

std::vector<Claim> thrash_claims(const ReportData& data) {
    return {judge_knee(data),   judge_locality(data), judge_grows(data),
            judge_spared(data), judge_cause(data),    judge_here(data)};
}

}  // namespace edgewise::reports
