// SPDX-License-Identifier: MIT
#include "edgewise/reports/pictures/ranking_pictures.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/reports/text/report_text.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

constexpr double decades_with_all_ticks = 2.5;

/// Values outside the ends are drawn at the ends.
class LogScale {
  public:
    /// 0 < low < high; pixels may run downwards.
    LogScale(double low, double high, double first_pixel, double last_pixel)
        : low_(low), high_(high), first_(first_pixel), last_(last_pixel) {
        assert(low > 0 && low < high);
    }

    [[nodiscard]] double place(double value) const {
        const double part = std::log(std::clamp(value, low_, high_) / low_) / std::log(high_ / low_);
        return first_ + part * (last_ - first_);
    }

    /// 1, 2 and 5 times powers of ten within the ends; of a wide axis powers of ten alone.
    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> all;
        const bool wide = std::log10(high_ / low_) > decades_with_all_ticks;
        for (int power = static_cast<int>(std::floor(std::log10(low_))); power <= std::log10(high_); ++power)
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double tick = digit * std::pow(10.0, power);
                if ((digit == 1 || !wide) && tick >= low_ && tick <= high_) all.push_back(tick);
            }
        return all;
    }

  private:
    double low_, high_, first_, last_;
};

std::string outline(const RankedCell& cell, double x, double y, double size) {
    if (cell.cell->judged())
        return fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}z", x - size, y - size, 2 * size, 2 * size,
                           -2 * size);
    if (cell.cell->algorithm == "gjk")
        return fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}h{:.1f}z", x, y - size, size, 1.8 * size, -2 * size);
    return fmt::format("M{0:.1f} {1:.1f}a{2:.1f} {2:.1f} 0 1 0 {3:.1f} 0a{2:.1f} {2:.1f} 0 1 0 {4:.1f} 0z",
                       x - size, y, size, 2 * size, -2 * size);
}

/// Returns the mark of a cell, with its name, ratio and error as a tooltip.
std::string mark_svg(const RankedCell& cell, double x, double y, double size) {
    const std::string_view colour = store::layout_colour(cell.cell->layout);
    return fmt::format("<path d=\"{}\" {}><title>{}</title></path>", outline(cell, x, y, size),
                       cell.meets_error()
                           ? fmt::format("fill=\"{}\" fill-opacity=\".8\"", colour)
                           : fmt::format("fill=\"none\" stroke=\"{}\" stroke-opacity=\".8\"", colour),
                       html_text(mark_text(cell)));
}

constexpr double strip_width = 300, strip_height = 34, strip_margin = 8, mark_size = 4;
constexpr double least_ratio = 0.25, most_ratio = 16;

LogScale strip_scale(const StripAxis& axis) {
    return {axis.low, axis.high, strip_margin, strip_width - strip_margin};
}

/// Half, one, two ...
std::vector<double> octaves(const StripAxis& axis) {
    std::vector<double> all;
    for (double tick = least_ratio; tick <= axis.high; tick *= 2)
        if (tick >= axis.low) all.push_back(tick);
    return all;
}

std::string strip_line(double x1, double x2, double y1, double y2, const char* style) {
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" class=\"{}\"/>", x1, y1, x2, y2, style);
}

std::string strip_label(const SceneRanking& scene) {
    const RankedCell* choice = scene.choice();
    const RankedCell &first = scene.cells.front(), &last = scene.cells.back();
    std::string text = fmt::format("{} on an axis of time over the baseline's, from {:.2f} to {:.2f}",
                                   plural(scene.cells.size(), "table type"), first.ratio, last.ratio);
    return choice ? fmt::format("{}: {}. {}", choice->name(), ratio_text(*choice), text) : text;
}

}  // namespace

std::string mark_text(const RankedCell& cell) {
    std::string text = fmt::format("{}: {}", cell.name(), ratio_text(cell));
    if (cell.worst_error) append(text, "error " + number_text(*cell.worst_error, "scale"));
    if (cell.bytes_per_edge) append(text, number_text(*cell.bytes_per_edge, "B/edge") + " bytes per edge");
    return text;
}

StripAxis strip_axis(const std::vector<const SceneRanking*>& scenes) {
    StripAxis axis;
    for (const SceneRanking* scene : scenes) {
        for (const RankedCell& one : scene->cells) {
            axis.low = std::clamp(one.low() * 0.95, least_ratio, axis.low);
            axis.high = std::clamp(one.high() * 1.05, axis.high, most_ratio);
        }
    }
    return axis;
}

std::string strip_svg(const SceneRanking& scene, const StripAxis& axis) {
    const LogScale x = strip_scale(axis);
    std::string svg =
        fmt::format("<svg class=\"strip\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", strip_width,
                    strip_height, html_text(strip_label(scene)));
    if (scene.own_variation.factor)
        svg += fmt::format(
            "<rect x=\"{:.1f}\" y=\"0\" width=\"{:.1f}\" height=\"{}\" class=\"noise\"/>",
            x.place(scene.own_variation.low()),
            std::max(1.0, x.place(scene.own_variation.high()) - x.place(scene.own_variation.low())),
            strip_height);
    for (const double tick : octaves(axis))
        svg += strip_line(x.place(tick), x.place(tick), 0, strip_height, tick == 1 ? "one" : "grid");
    // The winner last, so that nothing covers it.
    for (auto one = scene.cells.rbegin(); one != scene.cells.rend(); ++one)
        svg += mark_svg(*one, x.place(one->ratio), one->cell->algorithm == "gjk" ? 22 : 11, mark_size);
    if (const RankedCell* choice = scene.choice())
        svg += strip_line(x.place(choice->low()), x.place(choice->high()), strip_height - 3, strip_height - 3,
                          "interval");
    return svg + "</svg>";
}

std::string strip_head_svg(const StripAxis& axis) {
    const LogScale x = strip_scale(axis);
    std::string svg =
        fmt::format("<svg class=\"strip\" viewBox=\"0 0 {} 14\" aria-hidden=\"true\">", strip_width);
    for (const double tick : octaves(axis))
        svg += fmt::format("<text x=\"{:.1f}\" y=\"11\" text-anchor=\"middle\">{:g}</text>", x.place(tick),
                           tick);
    return svg + "</svg>";
}

namespace {

constexpr double plot_width = 520, plot_height = 300, plot_left = 44, plot_right = 12, plot_top = 10,
                 plot_bottom = 38;

struct PlotAxes {
    LogScale x, y;
};

/// Room for every point.
PlotAxes plot_axes(const SceneRanking& scene) {
    double least_bytes = 1e9, most_bytes = 1, least = 0.8, most = 1.25;
    for (const RankedCell& one : scene.cells) {
        if (!one.bytes_per_edge || !(*one.bytes_per_edge > 0)) continue;
        least_bytes = std::min(least_bytes, *one.bytes_per_edge);
        most_bytes = std::max(most_bytes, *one.bytes_per_edge);
        least = std::min(least, one.ratio), most = std::max(most, one.ratio);
    }
    return {{std::min(least_bytes, most_bytes) * 0.75, most_bytes * 1.5, plot_left, plot_width - plot_right},
            {least * 0.9, most * 1.1, plot_height - plot_bottom, plot_top}};
}

std::string plot_frame(const PlotAxes& axes, const OwnVariation& noise) {
    std::string svg;
    if (noise.factor)
        svg += fmt::format("<rect x=\"{}\" y=\"{:.1f}\" width=\"{}\" height=\"{:.1f}\" class=\"noise\"/>",
                           plot_left, axes.y.place(noise.high()), plot_width - plot_left - plot_right,
                           std::max(1.0, axes.y.place(noise.low()) - axes.y.place(noise.high())));
    for (const double tick : axes.x.ticks())
        svg += fmt::format(
            "<path d=\"M{0:.1f} {1}V{2}\" class=\"grid\"/><text x=\"{0:.1f}\" y=\"{3}\" "
            "text-anchor=\"middle\">{4:g}</text>",
            axes.x.place(tick), plot_top, plot_height - plot_bottom, plot_height - plot_bottom + 14, tick);
    for (const double tick : axes.y.ticks())
        svg += fmt::format(
            "<path d=\"M{1} {0:.1f}H{2}\" class=\"{5}\"/><text x=\"{3}\" y=\"{0:.1f}\" dy=\"3\" "
            "text-anchor=\"end\">{4:g}</text>",
            axes.y.place(tick), plot_left, plot_width - plot_right, plot_left - 5, tick,
            tick == 1 ? "one" : "grid");
    return svg + fmt::format(
                     "<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">bytes per edge</text>"
                     "<text transform=\"translate(10 {:.1f}) rotate(-90)\" text-anchor=\"middle\">"
                     "time / time of the baseline</text>",
                     (plot_left + plot_width - plot_right) / 2, plot_height - 6,
                     (plot_top + plot_height - plot_bottom) / 2);
}

std::string front_line(const SceneRanking& scene, const std::vector<std::size_t>& front,
                       const PlotAxes& axes) {
    std::string path;
    for (const std::size_t i : front) {
        const RankedCell& one = scene.cells[i];
        const double x = axes.x.place(*one.bytes_per_edge), y = axes.y.place(one.ratio);
        path += path.empty() ? fmt::format("M{:.1f} {:.1f}", x, y) : fmt::format("H{:.1f}V{:.1f}", x, y);
    }
    return path.empty() ? path : "<path d=\"" + path + "\" class=\"front\"/>";
}

/// Returns names below the points of the front. A name that would cover the last name is only in its tooltip.
std::string front_names(const SceneRanking& scene, const std::vector<std::size_t>& front,
                        const PlotAxes& axes) {
    constexpr double letter = 6, line_height = 12;
    std::string svg;
    double last_y = -100, last_end = -100;
    for (const std::size_t i : front) {
        const RankedCell& one = scene.cells[i];
        const std::string name = one.name();
        const double x = axes.x.place(*one.bytes_per_edge), y = axes.y.place(one.ratio) + line_height + 1;
        const double length = letter * static_cast<double>(name.size());
        const bool at_right = x + length > plot_width;
        const double start = at_right ? x - 7 - length : x + 7;
        if (start < last_end && std::abs(y - last_y) < line_height) continue;
        last_y = y, last_end = start + length;
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"name\">{}</text>",
                           at_right ? x - 7 : x + 7, y, at_right ? "end" : "start", html_text(name));
    }
    return svg;
}

std::string plot_label(const SceneRanking& scene, const std::vector<std::size_t>& front) {
    std::string names;
    for (const std::size_t i : front) append(names, mark_text(scene.cells[i]), "; ");
    return fmt::format("Time against bytes, {}. On the front: {}", scene.label, names);
}

}  // namespace

std::vector<std::size_t> front_of_time_and_bytes(const SceneRanking& scene) {
    std::vector<SpeedError> plane;
    for (const RankedCell& one : scene.cells)
        plane.push_back(
            {one.ratio, one.meets_error() ? one.bytes_per_edge.value_or(on_no_front) : on_no_front});
    const std::vector<bool> on_front = pareto_front(plane);
    std::vector<std::size_t> front;
    for (std::size_t i = 0; i < plane.size(); ++i)
        if (on_front[i]) front.push_back(i);
    std::ranges::sort(front, [&](std::size_t a, std::size_t b) {
        return *scene.cells[a].bytes_per_edge < *scene.cells[b].bytes_per_edge;
    });
    return front;
}

std::string standalone(const std::string& svg) {
    const std::size_t end = svg.find('>');
    return fmt::format(
        "{} xmlns=\"http://www.w3.org/2000/svg\" font-family=\"sans-serif\" font-size=\"10\">"
        "<style>{}</style><rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>{}\n",
        svg.substr(0, end), report_text("page.picture.css"), svg.substr(end + 1));
}

std::string time_bytes_svg(const SceneRanking& scene) {
    const std::vector<std::size_t> front = front_of_time_and_bytes(scene);
    if (front.empty()) return {};
    const PlotAxes axes = plot_axes(scene);
    std::string svg = fmt::format("<svg class=\"plot\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
                                  plot_width, plot_height, html_text(plot_label(scene, front)));
    svg += plot_frame(axes, scene.own_variation) + front_line(scene, front, axes);
    for (auto one = scene.cells.rbegin(); one != scene.cells.rend(); ++one)
        if (one->bytes_per_edge && *one->bytes_per_edge > 0)
            svg += mark_svg(*one, axes.x.place(*one->bytes_per_edge), axes.y.place(one->ratio), 4.5);
    return svg + front_names(scene, front, axes) + "</svg>";
}

namespace {

constexpr double map_left = 132, map_cell_width = 84, map_cell_height = 32, map_gap = 3, map_head = 30,
                 map_panel_head = 24, map_bar = 6, map_letter = 5;

/// Text of a given class, squeezed where it would not fit.
std::string map_text(double x, double y, double room, const std::string& text, const char* style) {
    const bool long_one = static_cast<double>(text.size()) * map_letter > room;
    return fmt::format(
        "<text x=\"{:.0f}\" y=\"{:.0f}\" class=\"{}\"{}>{}</text>", x, y, style,
        long_one ? fmt::format(" textLength=\"{:.0f}\" lengthAdjust=\"spacingAndGlyphs\"", room) : "",
        html_text(text));
}

/// Returns the bar at the left end of a place: a part for each layout that wins or ties, at most four.
std::string map_bar_of(const MapCell& cell, double x, double y) {
    const std::size_t parts = std::min<std::size_t>(cell.scene->ties.size(), 4);
    const double height = (map_cell_height - map_gap) / static_cast<double>(parts);
    std::string svg;
    for (std::size_t i = 0; i < parts; ++i)
        svg += fmt::format("<path d=\"M{:.0f} {:.1f}h{}v{:.1f}h-{}z\" fill=\"{}\"/>", x,
                           y + height * static_cast<double>(i), map_bar, height, map_bar,
                           store::layout_colour(cell.scene->cells[cell.scene->ties[i]].cell->layout));
    return svg;
}

/// "0.72, 3 tie"
std::string map_ratio(const MapCell& cell) {
    if (cell.scene->too_noisy()) return "too noisy";
    const std::string ratio = fmt::format("{:.2f}", cell.winner()->ratio);
    const std::size_t ties = cell.scene->ties.size();
    return ties == 1 ? ratio : fmt::format("{}, {} tie", ratio, ties);
}

std::string map_cell_svg(const MapCell& cell, const std::string& shape, double x, double y) {
    const double width = map_cell_width - map_gap, height = map_cell_height - map_gap;
    const std::string scene =
        cell.scene ? fmt::format(" data-scene=\"{}\"", html_text(cell.scene->label)) : std::string();
    std::string svg = fmt::format("<g data-shape=\"{}\"{}><title>{}</title>", html_text(shape), scene,
                                  html_text(cell_text(cell)));
    const std::string box = fmt::format("<path d=\"M{:.0f} {:.0f}h{}v{}h-{}z\"", x, y, width, height, width);
    if (!cell.winner())
        return svg + box + " class=\"unmeasured\"/>" +
               map_text(x + 8, y + height / 2 + 3.5, width - 12,
                        cell.scene ? "none within error" : "not measured", "") +
               "</g>";
    svg += box + (cell.is_won() ? fmt::format(" fill=\"{}\" fill-opacity=\".25\"/>",
                                              store::layout_colour(cell.winner()->cell->layout))
                                : " class=\"tied\"/>");
    svg += map_bar_of(cell, x, y);
    svg += map_text(x + 10, y + 12, width - 13, cell.winner()->table, "name");
    svg += mark_svg(*cell.winner(), x + 14, y + 21, 4);
    return svg + map_text(x + 22, y + 24, width - 25, map_ratio(cell), "name") + "</g>";
}

std::string map_columns_svg(const std::vector<MapColumn>& columns) {
    std::string svg = map_text(0, 12, map_left - 6, "vertices", "");
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const double x = map_left + map_cell_width * static_cast<double>(i);
        svg += map_text(x, 12, map_cell_width - map_gap, std::to_string(columns[i].vertices), "name");
        svg += map_text(x, 24, map_cell_width - map_gap, columns[i].shape, "");
    }
    return svg;
}

}  // namespace

std::string break_even_svg(const BreakEvenMap& map) {
    if (map.measured() == 0) return {};
    const double width = map_left + map_cell_width * static_cast<double>(map.columns.size());
    std::string body = map_columns_svg(map.columns);
    double y = map_head;
    for (const MapPanel& panel : map.panels) {
        const std::string only = panel.only_algorithm();
        const std::string alone = only.empty() ? "" : fmt::format(" ({} alone was timed)", only);
        body += map_text(0, y + 14, width, panel.tables + alone, "panel");
        y += map_panel_head;
        for (const MapRow& row : panel.rows) {
            body += map_text(0, y + map_cell_height / 2 + 2, map_left - 6, row.coherence, "");
            for (std::size_t i = 0; i < row.cells.size(); ++i)
                body += map_cell_svg(row.cells[i], map.columns[i].shape,
                                     map_left + map_cell_width * static_cast<double>(i), y);
            y += map_cell_height;
        }
    }
    return fmt::format(
        "<svg class=\"map\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" role=\"img\" "
        "aria-label=\"{2}\">{3}</svg>",
        width, y, html_text("Who wins where. " + break_even_sentence(map)), body);
}

}  // namespace edgewise::reports
