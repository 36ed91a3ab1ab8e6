// SPDX-License-Identifier: MIT
//
// Computes the parts of every claim from a store, as claims.json writes them: an expression, and the band
// that its value is wanted in. An expression is a number, "$NAME" of the claim's "with", or a list that
// begins with an operation. Cells are named "ALGORITHM SCENE SHAPE TABLE"; * or nothing means any, and of
// tables aos_f64. A curve is an object: a "figure" or the "time" of cells, or their time "ratio" to others,
// by a number of the scene; "rad_per_s" and "rad" limit it to a range. "each" repeats a part with its words
// for {0} and {1}.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "edgewise/reports/paper/claims/claim_cells.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

using ClaimFile = nlohmann::ordered_json;
using Rows = std::vector<const ReportCell*>;

/// The store, and the names and the time step of one claim.
struct Scope {
    const ReportData& data;
    const ClaimFile& names;  ///< the claim's "with"
    double time_step = 0;    ///< s; turns speeds into angles per step
};

/// Points by x, and the reason if there are none.
struct Curve {
    std::vector<CurvePoint> points;
    std::string none;
};

std::string word(const ClaimFile& list, std::size_t i) { return list.at(i).get<std::string>(); }

/// The item with these words for {0}, {1}, ...
ClaimFile filled(ClaimFile item, const ClaimFile& words) {
    item.erase("each");
    std::string text = item.dump();
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string place = fmt::format("{{{}}}", i);
        for (std::size_t at = 0; (at = text.find(place)) != text.npos;)
            text.replace(at, place.size(), word(words, i));
    }
    return ClaimFile::parse(text);
}

/// Repeats each object of a list that has "each": once for each of its lists of words.
std::vector<ClaimFile> expanded(const ClaimFile& list) {
    std::vector<ClaimFile> all;
    for (const ClaimFile& item : list) {
        if (item.is_object() && item.contains("each"))
            for (const ClaimFile& words : item["each"]) all.push_back(filled(item, words));
        else
            all.push_back(item);
    }
    return all;
}

/// Returns the expression of "$NAME".
const ClaimFile& named(const ClaimFile& name, const Scope& scope) {
    return scope.names.at(name.get<std::string>().substr(1));
}

std::vector<CurveCell> cells_of(const ClaimFile& curve, const char* member, const Scope& scope) {
    const auto found = cells_along(scope.data, key_of(curve.at(member)), curve.at("by"));
    const auto range = [&](const char* unit, double factor) {
        return CurveRange{factor * curve[unit][0].get<double>(), factor * curve[unit][1].get<double>()};
    };
    if (curve.contains("rad")) return in_range(found, range("rad", 1));
    return curve.contains("rad_per_s") ? in_range(found, range("rad_per_s", scope.time_step)) : found;
}

Curve stored_curve(const ClaimFile& curve, const Scope& scope) {
    const char* const cells = curve.contains("ratio") ? "ratio" : curve.contains("time") ? "time" : "of";
    const CellKey key = key_of(curve.at(cells));
    Curve found{{},
                fmt::format("no cells of scene {}, {} on {},{} are stored", key.scene, key.algorithm,
                            key.table, curve.contains("rad_per_s") ? " with speeds in the range," : "")};
    const std::vector<CurveCell> along = cells_of(curve, cells, scope);
    if (curve.contains("ratio")) {
        found.points = ratio_curve(along, cells_of(curve, "to", scope));
    } else {
        for (const CurveCell& at : along)
            found.points.push_back(
                {at.x, curve.contains("time") ? time_of(*at.cell) : figure_of(*at.cell, curve.at("figure"))});
    }
    return found;
}

/// Returns true if the expression has a value at each x: a curve, or an operation on curves.
bool is_curve(const ClaimFile& expression, const Scope& scope) {
    if (expression.is_string()) return is_curve(named(expression, scope), scope);
    if (expression.is_object()) return !expression.contains("each");
    constexpr const char* pointwise[] = {"/", "+", "no less than", "known"};
    return expression.is_array() && std::ranges::find(pointwise, expression[0]) != std::end(pointwise) &&
           is_curve(expression[1], scope);
}

Curve curve_of(const ClaimFile& expression, const Scope& scope) {
    if (expression.is_string()) return curve_of(named(expression, scope), scope);
    if (expression.is_object()) return stored_curve(expression, scope);
    const std::string operation = word(expression, 0);
    Curve a = curve_of(expression[1], scope);
    if (operation == "known") {  // without any the reason is theirs
        const auto is_missing = [](const CurvePoint& point) { return !point.y.value; };
        if (!std::ranges::all_of(a.points, is_missing)) std::erase_if(a.points, is_missing);
        return a;
    }
    if (operation == "no less than") {
        for (CurvePoint& point : a.points) point.y = no_less_than(point.y, expression[2]);
        return a;
    }
    const Curve b = curve_of(expression[2], scope);
    return {joined_curve(a.points, b.points, operation == "/" ? quotient : sum),
            a.points.empty() ? a.none : b.none};
}

Evidence value_of(const ClaimFile& expression, const Scope& scope);

/// Calls `pick` with all values after an operation, or with those of its curve.
Evidence pick_of(Evidence (*pick)(const std::vector<Evidence>&, const std::string&), const ClaimFile& list,
                 const Scope& scope) {
    std::vector<Evidence> values;
    if (is_curve(list[1], scope)) {
        const Curve curve = curve_of(list[1], scope);
        for (const CurvePoint& point : curve.points) values.push_back(point.y);
        return pick(values, curve.none);
    }
    for (const ClaimFile& item : expanded({list.begin() + 1, list.end()}))
        values.push_back(value_of(item.is_object() ? item.at("is") : item, scope));
    return pick(values, "no such cell is stored");
}

/// A figure, or the "time", at the slowest speed above 0, the most coherent motion.
Evidence at_slowest(const std::string& what, const std::string& cells, const Scope& scope) {
    for (const CurveCell& at : cells_along(scope.data, key_of(cells), "rotation_step"))
        if (at.x > 0) return what == "time" ? time_of(*at.cell) : figure_of(*at.cell, what);
    return no_evidence(fmt::format("no cell of {} has a speed above 0", cells));
}

Evidence first_of(const Curve& curve) {
    return curve.points.empty() ? no_evidence(curve.none) : curve.points.front().y;
}
Evidence last_over_first(const Curve& curve) {
    if (curve.points.size() == 1) return no_evidence("only one such cell is stored");
    return quotient(curve.points.empty() ? first_of(curve) : curve.points.back().y, first_of(curve));
}

/// The largest fall from one point to the next.
Evidence largest_fall(const Curve& curve) {
    std::vector<Evidence> falls;
    for (std::size_t i = 1; i < curve.points.size(); ++i)
        falls.push_back(quotient(curve.points[i - 1].y, curve.points[i].y));
    return largest(falls, "fewer than two speeds are stored in the range");
}

/// Returns rows of V-Clip and GJK: cells of the "sweep", rows of the "families" of the stability run, or of
/// one algorithm on one table type in it, "families vclip aos_f64".
Rows rows_called(const std::string& name, const ReportData& data) {
    Rows rows = data.swept();
    if (name != "sweep") rows.clear();
    for (const ReportCell& row : data.stability)
        if (name == "families" || name == "families " + row.algorithm + " " + row.table) rows.push_back(&row);
    std::erase_if(rows, [](const ReportCell* row) {
        return row->is_raw() || (row->algorithm != "vclip" && row->algorithm != "gjk");
    });
    return rows;
}

/// Sums a figure over the rows that have it, with any status: failures of a failed cell count.
Evidence total(const Rows& rows, const std::string& name) {
    if (rows.empty()) return no_evidence("nothing of V-Clip and GJK is stored");
    Evidence all = no_evidence(stored_figure(*rows.front(), name).reason);
    for (const ReportCell* row : rows)
        if (const auto value = stored_figure(*row, name).value)
            all = exact_evidence(all.value.value_or(0) + *value);
    return all;
}

/// Cells of one scene, its parameters and one body are asked the same queries, whatever their algorithm,
/// table type and axes, so they are one sample. Returns the largest count of any such cell, summed over
/// scenes.
Evidence independent(const Rows& rows, const std::string& name) {
    std::map<std::tuple<std::string, std::string, std::string, std::uint64_t>, double> most;
    for (const ReportCell* row : rows)
        if (const auto value = stored_figure(*row, name).value) {
            double& of = most[{row->scene, row->scene_parameters, row->shape, row->seed}];
            of = std::max(of, *value);
        }
    Evidence all = total(rows, name);  // for its reason where there is none
    if (!all.value) return all;
    double queries = 0;
    for (const auto& [asked, count] : most) queries += count;
    return exact_evidence(queries);
}

/// Largest share of independent queries at which a cell may have failed. If none of n failed, the share is at
/// most 3/n with 95 % (rule of three).
Evidence bounded_share(const Evidence& failures, const Evidence& queries) {
    const Evidence share = quotient(failures, queries);
    if (!share.value || *share.value > 0) return share;
    return interval_evidence(0, 0, 3 / *queries.value);
}

/// Share of verdicts that are wrong at a tolerance, both algorithms together, in the families after the
/// table; in all of them if none is named.
Evidence wrong_share(const ClaimFile& list, const std::string& tolerance, const ReportData& data) {
    double failures = 0, cases = 0;
    const std::string table = word(list, 2);
    std::string why = "no stability run of such families on " + table + " is stored";
    for (const ReportCell& row : data.stability) {
        if (row.table != table ||
            (list.size() > 3 && std::find(list.begin() + 3, list.end(), row.shape) == list.end()))
            continue;
        const measure::Figure failed = stored_figure(row, "stability.failures_at_" + tolerance),
                              asked = row.figure("stability.cases");
        if (!failed.value || !asked.value) {
            why = failed.value ? asked.reason : failed.reason;
            continue;
        }
        failures += *failed.value;
        cases += *asked.value;
    }
    return cases > 0 ? exact_evidence(failures / cases) : no_evidence(why);
}

/// The share beyond that at the best of all tolerances that the stability run tries.
Evidence excess(const ClaimFile& list, const Scope& scope) {
    const Evidence here = wrong_share(list, word(list, 1), scope.data);
    if (!here.value) return here;
    double best = *here.value;
    for (const char* other :
         {"0e+00", "1e-16", "1e-14", "1e-12", "1e-10", "1e-08", "1e-06", "1e-05", "1e-03"})
        if (const Evidence share = wrong_share(list, other, scope.data); share.value)
            best = std::min(best, *share.value);
    return exact_evidence(*here.value - best);
}

/// The paging run's row of an algorithm on the paper's record, 386 vertices; null if it is not stored.
const ReportCell* paging_row(const ReportData& data, const std::string& algorithm) {
    for (const ReportCell& row : data.paging)
        if (row.algorithm == algorithm && row.table == "aos_f64" && row.shape == "sphere386") return &row;
    return nullptr;
}

/// A figure of an algorithm's row at its largest limit below `bound`, where 0 bytes mean no limit at all.
Evidence at_limit(const ReportData& data, const std::string& algorithm, double bound, const std::string& name,
                  const std::string& when_none) {
    const ReportCell* const row = paging_row(data, algorithm);
    if (!row)
        return no_evidence(fmt::format("no paging run of {} on aos_f64, sphere386, is stored", algorithm));
    int best = -1;
    double most = -1;
    for (int i = 0;; ++i) {
        const Evidence limit = figure_of(*row, fmt::format("paging.limit_bytes.{}", i));
        if (!limit.value) break;
        const double bytes = *limit.value > 0 ? *limit.value : 1e300;
        if (bytes < bound && bytes > most) best = i, most = bytes;
    }
    return best < 0 ? no_evidence(when_none) : figure_of(*row, fmt::format("{}.{}", name, best));
}

/// Returns the limit of V-Clip's row that is too small: half of what it touches, so that no choice of pages
/// can keep it.
Evidence tight_limit(const ReportData& data) {
    const ReportCell* const row = paging_row(data, "vclip");
    const Evidence touched = row ? figure_of(*row, "paging.touched_bytes") : exact_evidence(0);
    if (!touched.value) return touched;
    return at_limit(data, "vclip", *touched.value / 2, "paging.limit_bytes",
                    "no limit is below half of what V-Clip touches");
}

/// A figure of an algorithm's row at V-Clip's tight limit. Its own limits may all be smaller; with more
/// memory it faults no more often.
Evidence when_tight(const ReportData& data, const std::string& algorithm, const std::string& name) {
    const Evidence limit = tight_limit(data);
    if (!limit.value) return limit;
    return at_limit(data, algorithm, *limit.value + 1, name,
                    fmt::format("no row of {} has V-Clip's limit or a smaller one", algorithm));
}

Evidence failed_cells(const std::string& name, const ReportData& data) {
    const Rows rows = rows_called(name, data);
    return exact_evidence(static_cast<double>(
        std::ranges::count_if(rows, [](const ReportCell* row) { return row->failed(); })));
}

using Operation = std::function<Evidence(const ClaimFile& list, const Scope& scope)>;

// Operations on two values; on a list of values or the points of a curve; on a curve; on rows and a figure.
Operation on_two(Evidence (*of)(const Evidence&, const Evidence&)) {
    return [of](const ClaimFile& list, const Scope& scope) {
        return of(value_of(list[1], scope), value_of(list[2], scope));
    };
}
Operation on_all(Evidence (*pick)(const std::vector<Evidence>&, const std::string&)) {
    return [pick](const ClaimFile& list, const Scope& scope) { return pick_of(pick, list, scope); };
}
template <class Of>
Operation on_curve(Of of) {
    return [of](const ClaimFile& list, const Scope& scope) { return of(curve_of(list[1], scope)); };
}
Operation on_rows(Evidence (*of)(const Rows&, const std::string&)) {
    return [of](const ClaimFile& list, const Scope& scope) {
        return of(rows_called(word(list, 1), scope.data), word(list, 2));
    };
}

const std::map<std::string, Operation> operations = {
    {"figure", [](const auto& l, const Scope& s) { return figure_of(s.data, key_of(l[2]), word(l, 1)); }},
    {"time", [](const auto& l, const Scope& s) { return time_of(s.data, key_of(l[1])); }},
    {"ratio", [](const auto& l, const Scope& s) { return time_ratio(s.data, key_of(l[1]), key_of(l[2])); }},
    {"slowest", [](const auto& l, const Scope& s) { return at_slowest(word(l, 1), word(l, 2), s); }},
    {"/", on_two(quotient)},
    {"+", on_two(sum)},
    {"*", [](const auto& l, const Scope& s) { return multiple(value_of(l[2], s), l[1]); }},
    {"no less than", [](const auto& l, const Scope& s) { return no_less_than(value_of(l[1], s), l[2]); }},
    {"smallest", on_all(smallest)},
    {"largest", on_all(largest)},
    {"mean", on_all(geometric_mean)},
    {"first", on_curve(first_of)},
    {"last over first", on_curve(last_over_first)},
    {"largest fall", on_curve(largest_fall)},
    {"exponent", on_curve([](const Curve& curve) { return growth_exponent(curve.points); })},
    {"logarithm", on_curve([](const Curve& curve) { return log_or_power(curve.points).logarithm; })},
    {"power law", on_curve([](const Curve& curve) { return log_or_power(curve.points).power; })},
    {"total", on_rows(total)},
    {"independent", on_rows(independent)},
    {"failed", [](const auto& l, const Scope& s) { return failed_cells(word(l, 1), s.data); }},
    {"bounded share", on_two(bounded_share)},
    {"excess", excess},
    {"tight limit", [](const auto&, const Scope& s) { return tight_limit(s.data); }},
    {"when tight", [](const auto& l, const Scope& s) { return when_tight(s.data, word(l, 1), word(l, 2)); }},
    {"at ease", [](const auto& l, const Scope& s) {
         return at_limit(s.data, word(l, 1), 1e301, word(l, 2), "the paging run has no limit");
     }}};

/// Throws std::out_of_range for an operation, a name or a figure that does not exist.
Evidence value_of(const ClaimFile& expression, const Scope& scope) {
    if (expression.is_number()) return exact_evidence(expression);
    if (expression.is_string()) return value_of(named(expression, scope), scope);
    return operations.at(word(expression, 0))(expression, scope);
}

PartList parts_of(const ClaimFile& parts, const Scope& scope) {
    PartList all;
    for (const ClaimFile& part : expanded(parts))
        all.push_back(
            {part.at("label"), value_of(part.at("is"), scope), band_of(part), part.value("unit", "")});
    return all;
}

Claim judged(const ClaimFile& claim, const ReportData& data) {
    static const ClaimFile nothing = ClaimFile::object();
    const ClaimFile& names = claim.contains("with") ? claim["with"] : nothing;
    const ClaimFile &parts = claim.at("parts"), by = claim.value("depends on", ClaimFile());
    if (by.is_null()) return judge_claim(claim_of(claim), parts_of(parts, {data, names}));
    std::vector<ClaimVariant> variants;
    if (by == "time step")
        for (const TimeStepReading& reading : {reading_60th, reading_half})
            variants.push_back({reading.name, parts_of(parts, {data, names, reading.seconds})});
    else
        for (const ClaimFile& variant : expanded({{{"each", by["each"]}, {"name", "{0}"}, {"is", parts}}}))
            variants.push_back({variant["name"], parts_of(variant["is"], {data, names})});
    return judge_variants(claim_of(claim), by.is_string() ? by : by["what"], variants);
}

}  // namespace

std::vector<Claim> judge_claims(const ReportData& data) {
    static const ClaimFile claims = ClaimFile::parse(report_text("claims.json"));
    std::vector<Claim> all;
    for (const ClaimFile& claim : claims) {
        all.push_back(judged(claim, data));
        all.back().conditions = claim_conditions(data, all.back().deterministic);
    }
    return all;
}

}  // namespace edgewise::reports
