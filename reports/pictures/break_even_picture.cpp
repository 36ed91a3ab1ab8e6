// SPDX-License-Identifier: MIT
#include "edgewise/reports/pictures/break_even_picture.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/answer/break_even_map.hpp"
#include "edgewise/reports/pictures/ranking_pictures.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

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
    constexpr std::size_t most_parts = 4;
    std::vector<const RankedCell*> parts;
    for (const std::size_t i : cell.scene->ties)
        if (parts.size() < most_parts) parts.push_back(&cell.scene->cells[i]);
    const double height = (map_cell_height - map_gap) / static_cast<double>(parts.size());
    std::string svg;
    for (std::size_t i = 0; i < parts.size(); ++i)
        svg += fmt::format("<path d=\"M{:.0f} {:.1f}h{}v{:.1f}h-{}z\" fill=\"{}\"/>", x,
                           y + height * static_cast<double>(i), map_bar, height, map_bar,
                           store::layout_colour(parts[i]->cell->layout));
    return svg;
}

/// "0.72, 3 tie"
std::string map_ratio(const MapCell& cell) {
    if (cell.scene->too_noisy) return "too noisy";
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

std::string map_panel_title(const MapPanel& panel) {
    const std::string only = panel.only_algorithm();
    return only.empty() ? panel.tables : fmt::format("{} ({} alone was timed)", panel.tables, only);
}

}  // namespace

std::string break_even_svg(const BreakEvenMap& map) {
    if (map.measured() == 0) return {};
    const double width = map_left + map_cell_width * static_cast<double>(map.columns.size());
    std::string body = map_columns_svg(map.columns);
    double y = map_head;
    for (const MapPanel& panel : map.panels) {
        body += map_text(0, y + 14, width, map_panel_title(panel), "panel");
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
