// SPDX-License-Identifier: MIT
//
// What this machine's caches and memory do. Where its own caches thrash: time per query against the number of
// bodies, each with a table of its own, and under it the knee of the reuse distances beside the caches of
// this machine. And page faults per query against the memory that tables have: measured under limits (points)
// and predicted by the page-granular reuse distance (line), in one plot.
#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/paper/chapter/thrash_evidence.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

ChartJson bodies_of(const ReportCell& cell) {
    const auto bodies = scene_number(cell, "bodies");
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
    const auto traced = scene_number(*like, "bodies");
    if (!knee.value || !traced || *traced <= 0) return std::nullopt;
    estimated = true;
    return *knee.value * bodies / *traced;
}

ChartJson knees_of(const ReportData& data, const StoredScene& scene, std::vector<std::string>& notes) {
    ChartJson values = ChartJson::array();
    bool estimated = false;
    for (const ReportCell* cell : scene.cells) {
        const auto bodies = scene_number(*cell, "bodies");
        if (!bodies || !cell->verified()) continue;
        const auto knee = knee_of(data, *cell, *bodies, estimated);
        if (!knee || *knee <= 0) continue;
        ChartJson row = curve_json(*cell);
        row["bodies"] = *bodies;
        row["knee"] = *knee;
        values.push_back(std::move(row));
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

/// For a part that is there only with rows.
ChartJson if_any(const char* slot, const ChartJson& rows) {
    ChartJson list = ChartJson::array();
    if (!rows.empty()) list.push_back(ChartJson::object({{slot, rows}}));
    return list;
}

ChartJson fault_row(const ReportCell& cell, double memory, const char* kind, double faults) {
    ChartJson row = curve_json(cell);
    row["memory"] = memory;
    row["kind"] = kind;
    row["faults"] = faults;
    return row;
}

/// A limit's two places on the predicted line, and its measured point.
void add_limit(const ReportCell& cell, const PagingLimit& limit, ChartRows& rows) {
    const double held = limit.held.value.value_or(0), given = limit.limit.value.value_or(0);
    if (held > 0 && limit.predicted_at_held.value)
        rows.values.push_back(fault_row(cell, held, "predicted", *limit.predicted_at_held.value));
    if (given > 0 && limit.predicted_at_limit.value)
        rows.values.push_back(fault_row(cell, given, "predicted", *limit.predicted_at_limit.value));
    if (held > 0 && limit.faults.value)
        rows.values.push_back(fault_row(cell, held, "measured", *limit.faults.value));
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
