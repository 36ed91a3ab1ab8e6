// SPDX-License-Identifier: MIT
//
// Misses a query against the size of a cache, from exact reuse distances: one line an algorithm x table type,
// a row of panels a scene; lines of 64 bytes left, pages of 4 KiB right.
#include <cmath>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/cache_tables.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

ChartJson values_of(const ReportData& data) {
    ChartJson values = ChartJson::array();
    for (const ReportCell* cell : modelled_cells(data)) {
        for (const store::FigureRow& figure : cell->figures) {
            for (const store::ReuseNames& family : store::reuse_names) {
                const auto power = family.misses.value_in(figure.probe, figure.name);
                if (!power || !figure.value) continue;
                ChartJson row = cell_json(*cell);
                row["unit"] = family.units;
                row["bytes"] = std::ldexp(1.0, std::stoi(*power));
                row["misses"] = *figure.value;
                values.push_back(std::move(row));
            }
        }
    }
    return values;
}

/// Powers of 1024 by name.
constexpr const char* size_label =
    "datum.value >= 1073741824 ? datum.value / 1073741824 + ' GiB' : datum.value >= 1048576 ? datum.value / "
    "1048576 + ' MiB' : datum.value / 1024 + ' KiB'";

ChartJson encoding(const ReportData& data) {
    const ChartJson x{{"field", "bytes"},
                      {"type", "quantitative"},
                      {"title", "size of the cache"},
                      {"scale", {{"type", "log"}, {"base", 2}, {"nice", false}}},
                      {"axis", {{"labelExpr", size_label}, {"labelOverlap", true}, {"tickCount", 9}}}};
    // Zero has its place, and a few misses are told from none.
    const ChartJson y{{"field", "misses"},
                      {"type", "quantitative"},
                      {"title", "misses a query"},
                      {"scale", {{"type", "symlog"}}}};
    ChartJson tooltip = ChartJson::array();
    for (const char* name : {"table", "algorithm", "scene", "shape", "unit"})
        tooltip.push_back({{"field", name}, {"type", "nominal"}});
    for (const char* name : {"bytes", "misses"})
        tooltip.push_back({{"field", name}, {"type", "quantitative"}, {"format", ".4~g"}});
    return {{"x", x},
            {"y", y},
            {"color", layout_colour(data)},
            {"strokeDash", precision_dash(data)},
            {"detail", ChartJson::array({{{"field", "algorithm"}, {"type", "nominal"}},
                                         {{"field", "shape"}, {"type", "nominal"}}})},
            {"opacity", picked_opacity({"layout", "precision"})},
            {"tooltip", tooltip}};
}

}  // namespace

Chart misses_chart(const ReportData& data) {
    Chart chart{
        "misses",
        "Misses against the size of a cache",
        "Exact misses a query of a fully associative LRU cache of any size, in the steady pass: lines of 64 "
        "bytes left, pages of 4 KiB right. Where a curve falls to nothing all that the queries come back to "
        "fits; the knee in the table is where a tenth of the lines is left. Click a layout or a precision in "
        "the legend to dim the rest.",
        nullptr,
        {},
        {}};
    ChartJson values = values_of(data);
    if (values.empty()) return chart;
    thin(values, mark_limit / 2, chart.notes);
    const ChartJson unit{{"field", "unit"}, {"type", "nominal"}, {"title", nullptr}};
    chart.spec = {{"config", chart_config()},
                  {"data", {{"values", values}}},
                  {"facet", {{"row", scene_rows(data)}, {"column", unit}}},
                  {"resolve", {{"scale", {{"y", "independent"}, {"x", "independent"}}}}},
                  {"spec",
                   {{"width", 400},
                    {"height", 260},
                    {"params", ChartJson::array({legend_pick("layout"), legend_pick("precision")})},
                    {"mark", {{"type", "line"}, {"strokeWidth", 1.4}}},
                    {"encoding", encoding(data)}}}};
    chart.fallback = data_grid(values, {"scene", "unit", "shape", "algorithm", "table", "bytes", "misses"});
    return chart;
}

}  // namespace edgewise::reports
