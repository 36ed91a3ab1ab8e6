// SPDX-License-Identifier: MIT
//
// Speed against error: what accuracy a nanosecond buys, a panel for each scene with the shape chosen, with
// the front of time and the error chosen as a step line. The axis of errors is the same whatever is chosen,
// so that choices can be compared.

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <map>
#include <set>
#include <utility>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

ErrorAxis::ErrorAxis(std::vector<double> errors) : errors_(std::move(errors)) {
    assert(!errors_.empty());
    std::ranges::sort(errors_);
    const auto positive = std::upper_bound(errors_.begin(), errors_.end(), 0.0);
    const double least = positive == errors_.end() ? 1e-15 : std::min(1e-15, *positive);
    while (floor_ > least / 10 && floor_ > 1e-300) floor_ /= 10;
}

ChartJson ErrorAxis::ticks() const {
    ChartJson places = ChartJson::array();
    if (has_zeros()) places.push_back(floor_);
    const double first = has_zeros() ? 10 * floor_ : errors_.front();
    for (int power = -300; power <= 300; power += 2) {
        // Read from text: a product of tens would miss the decimal value by a rounding.
        const double place = std::stod(fmt::format("1e{}", power));
        if (place >= first && place <= errors_.back()) places.push_back(place);
    }
    return places;
}

ChartJson ErrorAxis::domain() const { return {place(errors_.front()), place(errors_.back())}; }

std::string ErrorAxis::tick_label() const {
    return fmt::format("datum.value < {:g} ? 'exactly 0' : format(datum.value, '.0e')", floor_ * 2);
}

namespace {

constexpr std::size_t most_panels = 12;  ///< of one shape, in view at once
constexpr const char* another_library = "another library";

/// "p50_front"
std::string member(const ErrorKind& kind, const char* what = "") { return std::string(kind.id) + what; }

/// Returns one row; errors that are unknown are null.
ChartJson speed_error_row(const FrontPoint& point) {
    const ReportCell& cell = *point.cell;
    ChartJson row = cell_json(cell);
    row["holder"] = cell.layout;  // a layout, or a library
    row["kind"] = cell.judged() ? another_library : cell.algorithm;
    if (const auto gap = cell.axis("gap_tolerance")) row["tolerance"] = *gap;
    row["ns"] = point.ns;
    for (std::size_t kind = 0; kind < error_kind_count; ++kind) {
        const auto& error = point.errors[kind];
        row[member(error_kinds[kind])] = error ? ChartJson(*error) : ChartJson();
        row[member(error_kinds[kind], "_front")] = bool(point.on_front[kind]);
    }
    return row;
}

/// A row for each; the fastest of a tolerance has it as its label: on each, labels would hide each other.
void add_rows_of(const FrontPanel& panel, ChartJson& rows) {
    std::set<std::string> labelled;
    for (const FrontPoint& point : panel.points) {
        rows.push_back(speed_error_row(point));
        const auto gap = point.cell->axis("gap_tolerance");
        if (gap && labelled.insert(*gap).second) rows.back()["label"] = "gap " + *gap;
    }
}

/// A row for each point; notes what has none.
ChartJson speed_error_rows(const Fronts& fronts, std::vector<std::string>& notes) {
    ChartJson rows = ChartJson::array();
    std::map<std::string, std::size_t> panels, not_drawn;
    for (const auto& [cell, why] : fronts.left_out) ++not_drawn[why];
    for (const FrontPanel& panel : fronts.panels) {
        if (panels[panel.shape]++ < most_panels) {
            add_rows_of(panel, rows);
        } else {
            not_drawn[fmt::format("of scenes beyond the first {} with their shape", most_panels)] +=
                panel.points.size();
        }
    }
    for (const auto& [why, count] : not_drawn)
        notes.push_back(fmt::format("Not drawn: {} ({}).", plural(count, "cell"), why));
    return rows;
}

/// Writes "p50_drawn" and the like, the places on the axis, into each row.
ErrorAxis place_on_axis(ChartJson& values) {
    std::vector<double> errors;
    for (const ChartJson& row : values)
        for (const ErrorKind& kind : error_kinds)
            if (row[member(kind)].is_number()) errors.push_back(row[member(kind)].get<double>());
    ErrorAxis axis(std::move(errors));
    for (ChartJson& row : values) {
        for (const ErrorKind& kind : error_kinds) {
            const ChartJson error = row[member(kind)];
            row[member(kind, "_drawn")] =
                error.is_number() ? ChartJson(axis.place(error.get<double>())) : error;
        }
    }
    return axis;
}

/// Notes how many points have no place on the axis, or a place without meaning.
void note_places(const ChartJson& values, std::vector<std::string>& notes) {
    for (const ErrorKind& kind : error_kinds) {
        std::size_t zeros = 0, missing = 0;
        for (const ChartJson& row : values) {
            zeros += row[member(kind)] == 0;
            missing += row[member(kind)].is_null();
        }
        const auto note = [&](std::size_t count, const std::string& text) {
            if (count > 0)
                notes.push_back(fmt::format("{} of {} points have {}", count, values.size(), text));
        };
        note(zeros,
             fmt::format("a {} error of exactly 0: they are drawn on the dotted line at the left edge; "
                         "the position of that line on the axis has no meaning.",
                         kind.title));
        note(missing, fmt::format("no {} error: they are not drawn with it.", kind.title));
    }
}

/// Returns the shapes of all panels, ordered by vertices.
ChartJson shapes_drawn(const Fronts& fronts) {
    std::set<std::pair<std::int64_t, std::string>> shapes;
    for (const FrontPanel& panel : fronts.panels) shapes.emplace(panel.vertices, panel.shape);
    ChartJson names = ChartJson::array();
    for (const auto& [vertices, shape] : shapes) names.push_back(shape);
    return names;
}

/// Algorithms with the shapes that they have everywhere, then squares; layouts with the colours that they
/// have everywhere, then libraries.
void add_orders(ChartJson& slots, const ReportData& data, const ChartJson& values) {
    const ChartJson orders = order_slots(data, values);
    slots["kinds"] = orders["algorithms"], slots["kind_shapes"] = orders["algorithm_shapes"];
    slots["kinds"].push_back(another_library);
    slots["kind_shapes"].push_back("square");
    ChartJson holders = orders["layouts"], colours = ChartJson::array();
    std::set<std::string> libraries;
    for (const ChartJson& row : values)
        if (row["kind"] == another_library) libraries.insert(row["holder"].get<std::string>());
    for (const std::string& library : libraries) holders.push_back(library);
    for (const ChartJson& holder : holders)
        colours.push_back(store::layout_colour(holder.get<std::string>()));
    slots["holders"] = holders, slots["holder_colours"] = colours;
}

}  // namespace

Chart speed_error_chart(const ReportData& data) {
    Chart chart = chart_of_file("speed_error");
    const Fronts fronts = fronts_of(data);
    ChartRows rows{speed_error_rows(fronts, chart.notes), {}};
    if (!take_rows(chart, rows)) return chart;
    const ErrorAxis axis = place_on_axis(rows.values);
    note_places(rows.values, chart.notes);
    const ChartJson shapes = shapes_drawn(fronts);
    // The reference shape is shown until another is chosen if it is drawn, else the largest.
    const std::string reference = reference_shape(data);
    const bool has_reference = std::find(shapes.begin(), shapes.end(), reference) != shapes.end();
    ChartJson floors = ChartJson::array();
    if (axis.has_zeros()) floors.push_back({{"floor", axis.floor()}});
    ChartJson slots{
        {"floors", floors},        {"ticks", axis.ticks()},
        {"domain", axis.domain()}, {"tick_label", axis.tick_label()},
        {"drawn_shapes", shapes},  {"first_shape", has_reference ? ChartJson(reference) : shapes.back()}};
    add_orders(slots, data, rows.values);
    draw(chart, data, rows.values, slots);
    return chart;
}

}  // namespace edgewise::reports
