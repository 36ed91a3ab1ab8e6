// SPDX-License-Identifier: MIT
//
// Caches and memory. Misses per query in the modelled caches of 2001 against the angle per step: a row of
// panels per cache level, a column a number of vertices. Misses against the size of a fully associative
// cache, of lines and of pages, at one angle per step: a row of panels per number of vertices; the cache and
// the memories of 2001 are rules in every panel. The study of figure 8: where its facts hold (the region of
// the queries alone), and the cells that were made real. Time per query on this machine against the number of
// bodies, each with a table of its own, and under it the knee of the reuse distances next to the caches of
// this machine. And page faults per query against the memory that tables have: measured under limits (points)
// and predicted by the page-granular reuse distance (line).

#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <set>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

void add_levels(const ReportCell& cell, ChartRows& rows) {
    const auto step = parameter_of(cell, "rotation_step");
    if (!step || *step <= 0) return;
    for (const OldLevel& level : old_levels) {
        const measure::Figure misses = cell.figure(store::level_misses.of(level.machine, level.level).warm());
        if (!cell.verified() || !misses.value) {
            rows.omitted.add(fmt::format("{}: {}", level.label, misses.reason));
            continue;
        }
        add_point(rows.values, curve_json(cell),
                  {{"level", level.label}, {"angle", *step}, {"misses", *misses.value}});
    }
}

/// Adds the scene's cells with the angle per step nearest to the shown one.
void add_scene(const StoredScene& scene, ChartJson& values) {
    std::set<std::pair<std::string, std::string>> done;
    for (const ReportCell* cell : scene.cells) {
        if (!done.emplace(cell->algorithm, cell->table).second) continue;
        const ReportCell* shown = nearest_cell(scene, cell->algorithm, cell->table, thrash_step_angle);
        if (shown) add_misses(*shown, curve_json(*shown), Starts::warm, values);
    }
}

/// Rules are rows too: a layer with data of its own would be drawn in every panel.
void add_rules(ChartJson& values) {
    struct Rule {
        const char *unit, *label;
        double bytes;
    };
    const Rule rules[] = {{"lines", "L2 of 2001", old_cache},
                          {"pages", "64 MiB", least_old_memory},
                          {"pages", "256 MiB", most_old_memory}};
    std::set<std::pair<std::string, std::int64_t>> panels;
    for (const ChartJson& row : values)
        panels.emplace(row["unit"].get<std::string>(), row["vertices"].get<std::int64_t>());
    for (const auto& [unit, vertices] : panels)
        for (const Rule& rule : rules)
            if (unit == rule.unit)
                values.push_back(
                    {{"unit", unit}, {"vertices", vertices}, {"rule", rule.bytes}, {"label", rule.label}});
}

std::string facts_text(unsigned facts) {
    constexpr std::pair<unsigned, const char*> names[] = {
        {rises, "rises"}, {takes_as_long, "takes as long"}, {spares_gjk, "spares GJK"}, {erratic, "erratic"}};
    std::vector<std::string> held;
    for (const auto& [fact, name] : names)
        if ((facts & fact) != 0) held.emplace_back(name);
    return held.empty() ? "none" : fmt::format("{}", fmt::join(held, ", "));
}

}  // namespace

Chart paper_misses_chart(const ReportData& data) {
    ChartRows rows;
    for (const int vertices : thrash_vertices)
        for (const ReportCell* cell : thrash_scene(data, vertices).cells) add_levels(*cell, rows);
    ChartJson levels = ChartJson::array();
    for (const OldLevel& level : old_levels) levels.push_back(level.label);
    return drawn_chart(chart_of_file("paper_thrash_misses"), data, std::move(rows), {{"levels", levels}});
}

Chart paper_reuse_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_reuse");
    ChartRows rows;
    for (const int vertices : thrash_vertices) add_scene(thrash_scene(data, vertices), rows.values);
    if (!take_rows(chart, rows)) return chart;
    add_rules(rows.values);
    draw(chart, data, rows.values);
    return chart;
}

Chart paper_region_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_region");
    ChartRows rows;
    for (const ThrashRow& row : thrash_rows(data)) {
        if (row.mechanism != "queries_alone") continue;
        for (const ScoredSetting& setting : row.settings)
            rows.values.push_back({{"tables", row.tables()},
                                   {"fault_us", setting.fault_ns / 1000},
                                   {"bodies", setting.bodies},
                                   {"memory", setting.memory_mib},
                                   {"facts", __builtin_popcount(setting.facts)},
                                   {"which", facts_text(setting.facts)}});
    }
    return drawn_chart(std::move(chart), data, std::move(rows), ChartJson::object(), "setting");
}

Chart paper_realised_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_realised");
    ChartRows rows;
    for (const RealisedRow& row : realised_rows(data)) {
        if (!row.cell->verified()) rows.omitted.add(row.cell->reason);
        for (const RealisedRow::Point& point : row.points)
            rows.values.push_back(
                {{"cell", row.what},
                 {"curve", fmt::format("{}, {} vertices", row.cell->algorithm, row.cell->vertices)},
                 {"speed", point.speed},
                 {"measured", point.measured_us},
                 {"predicted", point.predicted_us}});
    }
    return drawn_chart(std::move(chart), data, std::move(rows), ChartJson::object(), "point");
}

namespace {

ChartJson bodies_of(const ReportCell& cell) {
    const auto bodies = parameter_of(cell, "bodies");
    return bodies ? ChartJson::object({{"bodies", *bodies}}) : ChartJson();
}

/// The knee of the cell; where none was traced, that of the same table in the scene of the thrash, at the
/// same angle per step, in proportion to the bodies.
std::optional<double> knee_of(const ReportData& data, const ReportCell& cell, double bodies,
                              bool& estimated) {
    const measure::Figure own = cell.figure(store::line_knee.warm());
    if (own.value) return own.value;
    const ReportCell* like =
        nearest_cell(thrash_scene(data, 386), cell.algorithm, cell.table, thrash_step_angle);
    if (!like) return std::nullopt;
    const measure::Figure knee = like->figure(store::line_knee.warm());
    const auto traced = parameter_of(*like, "bodies");
    if (!knee.value || !traced || *traced <= 0) return std::nullopt;
    estimated = true;
    return *knee.value * bodies / *traced;
}

ChartJson knees_of(const ReportData& data, const StoredScene& scene, std::vector<std::string>& notes) {
    ChartJson values = ChartJson::array();
    bool estimated = false;
    for (const ReportCell* cell : scene.cells) {
        const auto bodies = parameter_of(*cell, "bodies");
        if (!bodies || !cell->verified()) continue;
        const auto knee = knee_of(data, *cell, *bodies, estimated);
        if (knee && *knee > 0) add_point(values, curve_json(*cell), {{"bodies", *bodies}, {"knee", *knee}});
    }
    if (estimated) notes.push_back(prose("knees_in_proportion.md"));
    if (values.empty()) notes.emplace_back("No knee is drawn: no reuse distances were traced.");
    return values;
}

/// This machine's data caches, as its description in the store names them.
ChartJson caches_of(const ReportData& data) {
    ChartJson rows = ChartJson::array();
    const auto machine = input::json_or_null(data.build.machine_json);
    if (!machine.is_object() || !machine.contains("caches") || !machine["caches"].is_array()) return rows;
    for (const auto& cache : machine["caches"]) {
        if (!cache.is_object() || cache.value("type", "") == "Instruction") continue;
        if (!cache.contains("bytes") || !cache["bytes"].is_number() || !cache.contains("level")) continue;
        rows.push_back({{"knee", cache["bytes"].get<double>()},
                        {"label", "L" + cache["level"].dump() + " of this machine"}});
    }
    return rows;
}

/// Returns a list with one part that has these rows; an empty list if there are no rows.
ChartJson if_any(const char* slot, const ChartJson& rows) {
    ChartJson list = ChartJson::array();
    if (!rows.empty()) list.push_back(ChartJson::object({{slot, rows}}));
    return list;
}

/// A limit's two places on the predicted line, and its measured point.
void add_limit(const ReportCell& cell, const PagingLimit& limit, ChartRows& rows) {
    const double held = limit.held.value.value_or(0), given = limit.limit.value.value_or(0);
    const auto add = [&](double memory, const char* kind, double faults) {
        add_point(rows.values, curve_json(cell), {{"memory", memory}, {"kind", kind}, {"faults", faults}});
    };
    if (held > 0 && limit.predicted_at_held.value) add(held, "predicted", *limit.predicted_at_held.value);
    if (given > 0 && limit.predicted_at_limit.value) add(given, "predicted", *limit.predicted_at_limit.value);
    if (held > 0 && limit.faults.value)
        add(held, "measured", *limit.faults.value);
    else
        rows.omitted.add(limit.faults.value ? limit.held.reason : limit.faults.reason);
}

}  // namespace

Chart paper_here_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_here");
    const StoredScene scene = scene_file(data, "paper_caches_here");
    ChartRows times;
    add_timed_rows(times, scene.cells, bodies_of);
    const ChartJson knees = knees_of(data, scene, chart.notes);
    return drawn_chart(
        std::move(chart), data, std::move(times),
        {{"knees", if_any("knee_values", knees)}, {"caches", if_any("cache_values", caches_of(data))}});
}

Chart paper_paging_chart(const ReportData& data) {
    Chart chart = chart_of_file("paper_thrash_paging");
    if (data.scene_files.empty()) chart.section.clear();
    ChartRows rows;
    bool keeps_recency = true;
    for (const ReportCell& row : data.paging) {
        keeps_recency = keeps_recency && row.figure("paging.keeps_recency").value.value_or(1) != 0;
        for (const PagingLimit& limit : paging_limits(row)) add_limit(row, limit, rows);
    }
    if (!take_rows(chart, rows, "limit")) return chart;
    if (!keeps_recency)
        chart.notes.emplace_back(
            "The system could throw out any page, not the least recent (read-ahead could not be set), so "
            "measured faults need not follow the line.");
    draw(chart, data, rows.values);
    return chart;
}

}  // namespace edgewise::reports
