// SPDX-License-Identifier: MIT
#include "edgewise/reports/pictures/marks.hpp"

#include <fmt/core.h>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

std::string outline(const RankedCell& cell, double x, double y, double size) {
    if (cell.cell->judged())
        return fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}z", x - size, y - size, 2 * size, 2 * size,
                           -2 * size);
    if (cell.cell->algorithm == "gjk")
        return fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}h{:.1f}z", x, y - size, size, 1.8 * size, -2 * size);
    return fmt::format("M{0:.1f} {1:.1f}a{2:.1f} {2:.1f} 0 1 0 {3:.1f} 0a{2:.1f} {2:.1f} 0 1 0 {4:.1f} 0z",
                       x - size, y, size, 2 * size, -2 * size);
}

}  // namespace

std::string mark_text(const RankedCell& cell) {
    std::string text = fmt::format("{}: {}", cell.name(), ratio_text(cell));
    if (cell.worst_error) append(text, "error " + number_text(*cell.worst_error, "scale"));
    if (cell.bytes_per_edge) append(text, number_text(*cell.bytes_per_edge, "B/edge") + " bytes per edge");
    return text;
}

std::string mark_svg(const RankedCell& cell, double x, double y, double size) {
    const std::string_view colour = store::layout_colour(cell.cell->layout);
    return fmt::format("<path d=\"{}\" {}><title>{}</title></path>", outline(cell, x, y, size),
                       cell.meets_error()
                           ? fmt::format("fill=\"{}\" fill-opacity=\".8\"", colour)
                           : fmt::format("fill=\"none\" stroke=\"{}\" stroke-opacity=\".8\"", colour),
                       html_text(mark_text(cell)));
}

}  // namespace edgewise::reports
