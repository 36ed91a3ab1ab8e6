// SPDX-License-Identifier: MIT
//
// Figures 6, 7 and 8 of the paper: time a query against angular speed, bodies of 8, 38 and 386 vertices. The
// axis is the effective angle a step: a turn beyond half a turn is a smaller one the other way round. The
// three charts have one scale of time, so that they can be laid side by side.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "edgewise/reports/charts/curves.hpp"
#include "edgewise/reports/paper/charts/paper_charts.hpp"
#include "edgewise/reports/paper/charts/turn.hpp"

namespace edgewise::reports {

namespace {

struct PaperFigure {
    int number, vertices;
    double slowest, fastest;  ///< the paper's axis, rad/s
    const char* top;          ///< of its axis of time
    const char* says;
};

constexpr PaperFigure figures[] = {
    {6, 8, 0, 12.57, "7e-5 s", "V-Clip slightly faster, both of comparable complexity"},
    {7, 38, 1, 7, "1e-4 s", "V-Clip consistently faster"},
    {8, 386, 1, 7, "1.2e-3 s, 12 times that of figure 7",
     "Enhanced GJK as with 8 and 38 vertices, V-Clip erratic"}};

/// Where a cell stands, and how: random orientations apart, with a shape of their own; what lies beyond half
/// a turn comes back over the same angles, as points that no line joins.
void set_turn(const ReportCell& cell, double step, ChartJson& row) {
    const bool random = is_random_turn(cell);
    row["angle"] = random ? random_turn : folded_angle(step);
    row["raw_angle"] = random ? ChartJson(nullptr) : ChartJson(step);
    row["apart"] = random;
    row["unjoined"] = random || step > std::numbers::pi + 1e-6;
    if (random) row["point"] = cell.algorithm + ", random orientations";
}

ChartJson values_of(const StoredScene& scene, Omissions& omitted) {
    ChartJson values = ChartJson::array();
    for (const ReportCell* cell : scene.cells) {
        const double step = scene_number(*cell, "rotation_step").value_or(0);
        ChartJson row = timed_row(*cell, store::all_time, omitted);
        if (row.is_null()) continue;
        set_turn(*cell, step, row);
        values.push_back(std::move(row));
    }
    return values;
}

std::string scene_of(const PaperFigure& figure) { return fmt::format("paper_angular_{}", figure.vertices); }

/// The slowest of the three figures: where their common scale ends.
double slowest_time(const ReportData& data) {
    double most = 0;
    Omissions ignored;
    for (const PaperFigure& figure : figures)
        for (const ChartJson& row : values_of(scene_file(data, scene_of(figure)), ignored))
            most = std::max(most, row["high"].get<double>());
    return most;
}

Curves curves_of(const PaperFigure& figure, double most) {
    Curves curves;
    curves.x = {"angle", "effective angle a step, rad", scale_with_zero(0.02),
                ticks_at({0, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 3})};
    curves.y = {"ns", "ns a query, median", scale_up_to(most)};
    curves.also = {"raw_angle"};
    const auto span = [&](double step, int row, const char* label) {
        // Beyond half a turn the axis comes back: all angles up to half a turn are on it.
        const double end = std::min(figure.fastest * step, std::numbers::pi);
        for (const auto& layer : span_layers(curves.x, figure.slowest * step, end, row, label))
            curves.behind.push_back(layer);
    };
    span(1.0 / 60, 0, "paper's axis, 60 steps a second");
    span(0.5, 1, "paper's axis, 2 steps a second");
    return curves;
}

std::string how_to_read(const PaperFigure& figure) {
    return fmt::format(
        "Each line is an algorithm on a table type: median time of all queries, as they come, with its 95 % "
        "interval, against the angle between two steps. Only the orientation counts for coherence, so a turn "
        "of w is drawn at w mod 2 pi or what is left of the turn, whichever is less: points beyond pi are "
        "not joined by a line, and the tooltip has the turn itself. Points of another shape are new random "
        "orientations every step, no coherence at all: they stand at their mean angle, pi/2 + 2/pi = 2.207 "
        "rad. The paper's axis goes from {} to {} rad/s (grey: at 60 and at 2 steps a second; it names "
        "neither) and ends at {}; it reports: {}. Figures 6, 7 and 8 share one scale of time.",
        figure.slowest, figure.fastest, figure.top, figure.says);
}

}  // namespace

Chart paper_angular_chart(const ReportData& data, int number) {
    const PaperFigure& figure = figures[number - figures[0].number];
    Chart chart{fmt::format("paper_figure_{}", number),
                fmt::format("Figure {}: time against angular speed ({} vertices)", number, figure.vertices),
                how_to_read(figure),
                nullptr,
                {},
                {},
                number == 6 ? dynamic_section : scalability_section};
    Omissions omitted;
    const ChartJson values = values_of(scene_file(data, scene_of(figure)), omitted);
    if (values.empty()) return chart;
    omitted.write("cell", chart.notes);
    chart.spec = curve_spec(data, values, curves_of(figure, slowest_time(data)));
    chart.fallback =
        data_grid(values, {"angle", "raw_angle", "point", "algorithm", "table", "ns", "low", "high"});
    return chart;
}

}  // namespace edgewise::reports
