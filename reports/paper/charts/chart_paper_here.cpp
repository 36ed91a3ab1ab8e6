// SPDX-License-Identifier: MIT
//
// Where this machine's own caches thrash: time a query against the number of bodies, each with a table of its
// own, and under it the knee of the reuse distances beside the caches of this machine.
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/chapter/stored_scene.hpp"
#include "edgewise/reports/paper/chapter/thrash_scenes.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"

namespace edgewise::reports {

namespace {

constexpr const char* scene_name = "paper_caches_here";

CurveAxis bodies_axis() { return {"bodies", "bodies", log_scale(), {{"format", "~s"}, {"tickCount", 7}}}; }

ChartJson times_of(const StoredScene& scene, Omissions& omitted) {
    ChartJson values = ChartJson::array();
    for (const ReportCell* cell : scene.cells) {
        const auto bodies = scene_number(*cell, "bodies");
        if (!bodies) continue;
        ChartJson row = timed_row(*cell, store::all_time, omitted);
        if (row.is_null()) continue;
        row["bodies"] = *bodies;
        values.push_back(std::move(row));
    }
    return values;
}

/// The knee of the cell; where none was traced, that of the same table in the scene of the thrash, at the
/// same angle a step, in proportion to the bodies.
std::optional<double> knee_of(const ReportData& data, const ReportCell& cell, double bodies,
                              bool& estimated) {
    const measure::Figure own = cell.figure("reuse.line_knee_bytes");
    if (own.value) return own.value;
    const ReportCell* like =
        nearest_cell(scene_file(data, "paper_thrash_386"), cell.algorithm, cell.table, thrash_turn);
    if (!like) return std::nullopt;
    const measure::Figure knee = like->figure("reuse.line_knee_bytes");
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
    if (estimated)
        notes.emplace_back(
            "Knees of cells whose reuse distances were not traced are those of paper_thrash_386 with the "
            "same "
            "table at 7/60 rad a step, in proportion to the number of bodies.");
    if (values.empty()) notes.emplace_back("No knee is drawn: no reuse distances were traced.");
    return values;
}

/// Horizontal rules: this machine's data caches, as its description in the store names them.
ChartJson cache_layers(const ReportData& data, const CurveAxis& knee) {
    ChartJson rows = ChartJson::array();
    const auto machine = nlohmann::json::parse(data.build.machine_json, nullptr, false);
    if (!machine.is_object() || !machine.contains("caches") || !machine["caches"].is_array()) return rows;
    for (const auto& cache : machine["caches"]) {
        if (!cache.is_object() || cache.value("type", "") == "Instruction") continue;
        if (!cache.contains("bytes") || !cache["bytes"].is_number() || !cache.contains("level")) continue;
        rows.push_back({{knee.field, cache["bytes"].get<double>()},
                        {"label", "L" + cache["level"].dump() + " of this machine"}});
    }
    const ChartJson own{{"values", rows}}, y = curve_axis(knee);
    const ChartJson rule{{"data", own},
                         {"mark", {{"type", "rule"}, {"color", "#8a929c"}, {"strokeDash", {3, 3}}}},
                         {"encoding", {{"y", y}}}};
    const ChartJson text{
        {"data", own},
        {"mark", {{"type", "text"}, {"align", "left"}, {"dy", -6}, {"fontSize", 9.5}, {"color", "#5a626c"}}},
        {"encoding", {{"x", {{"value", 4}}}, {"y", y}, {"text", {{"field", "label"}, {"type", "nominal"}}}}}};
    return ChartJson::array({rule, text});
}

ChartJson time_panel(const ReportData& data, const ChartJson& values) {
    Curves curves;
    curves.x = bodies_axis();
    curves.y = {"ns", "ns a query, median", scale_from_zero()};
    curves.width = 480;
    ChartJson panel{{"data", {{"values", values}}}};
    panel.update(curve_layers(data, values, curves));
    return panel;
}

ChartJson knee_panel(const ReportData& data, const ChartJson& values) {
    Curves curves;
    curves.x = bodies_axis();
    curves.y = bytes_axis("knee", "line knee");
    curves.has_interval = false;
    curves.behind = cache_layers(data, curves.y);
    curves.width = 480;
    ChartJson panel{{"data", {{"values", values}}}};
    ChartJson layers = curve_layers(data, values, curves);
    // The time panel's legends pick in both.
    for (ChartJson& layer : layers["layer"].back()["layer"]) layer.erase("params");
    panel.update(layers);
    return panel;
}

}  // namespace

Chart paper_here_chart(const ReportData& data) {
    Chart chart{
        "paper_thrash_here",
        "The thrash on this machine",
        "Left: median time of a query with its 95 % interval against the number of bodies, 386 vertices, "
        "tables of their own. Right: the knee of the reuse distances, the smallest cache in "
        "which a query brings in again at most a tenth of the lines it touches, beside this machine's "
        "caches. Where a knee passes a cache, the times to its left rise.",
        nullptr,
        {},
        {},
        thrash_section};
    Omissions omitted;
    const StoredScene scene = scene_file(data, scene_name);
    const ChartJson times = times_of(scene, omitted);
    if (times.empty()) return chart;
    const ChartJson knees = knees_of(data, scene, chart.notes);
    omitted.write("cell", chart.notes);
    ChartJson panels = ChartJson::array({time_panel(data, times)});
    if (!knees.empty()) panels.push_back(knee_panel(data, knees));
    chart.spec = {{"config", chart_config()}, {"hconcat", panels}};
    chart.fallback = data_grid(times, {"bodies", "algorithm", "table", "ns", "low", "high"});
    return chart;
}

}  // namespace edgewise::reports
