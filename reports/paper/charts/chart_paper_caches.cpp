// SPDX-License-Identifier: MIT
//
// Misses per query in the modelled caches of 2001 against the angle per step: a row of panels per cache
// level, a column a number of vertices. And against the size of a fully associative cache, of lines and of
// pages, at one angle per step: a row of panels per number of vertices; the cache and the memories of 2001
// stand as rules in every panel. And the study of figure 8: where its facts hold (the region of the queries
// alone), and the cells that were made real.
#include <fmt/core.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <set>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/paper/chapter/thrash_evidence.hpp"
#include "edgewise/reports/paper/chapter/thrash_study.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

void add_levels(const ReportCell& cell, ChartRows& rows) {
    const auto step = scene_number(cell, "rotation_step");
    if (!step || *step <= 0) return;
    for (const OldLevel& level : old_levels) {
        const measure::Figure misses = cell.figure(store::level_misses.of(level.machine, level.level).warm());
        if (!cell.verified() || !misses.value) {
            rows.omitted.add(fmt::format("{}: {}", level.label, misses.reason));
            continue;
        }
        ChartJson row = curve_json(cell);
        row["level"] = level.label;
        row["angle"] = *step;
        row["misses"] = *misses.value;
        rows.values.push_back(std::move(row));
    }
}

ChartJson levels_in_order() {
    ChartJson labels = ChartJson::array();
    for (const OldLevel& level : old_levels) labels.push_back(level.label);
    return labels;
}

/// The scene's cells whose angle per step is nearest to the one that is shown.
void add_scene(const StoredScene& scene, ChartJson& values) {
    std::set<std::pair<std::string, std::string>> done;
    for (const ReportCell* cell : scene.cells) {
        if (!done.emplace(cell->algorithm, cell->table).second) continue;
        const ReportCell* shown = nearest_cell(scene, cell->algorithm, cell->table, thrash_step_angle);
        if (shown) add_misses(*shown, curve_json(*shown), Starts::warm, values);
    }
}

/// Rules are rows too: a layer with data of its own would stand in every panel.
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
    return drawn_chart(chart_of_file("paper_thrash_misses"), data, std::move(rows),
                       {{"levels", levels_in_order()}});
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

}  // namespace edgewise::reports
