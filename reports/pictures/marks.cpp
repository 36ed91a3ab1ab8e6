// SPDX-License-Identifier: MIT
#include "edgewise/reports/pictures/marks.hpp"

#include <fmt/core.h>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

std::string outline(const Candidate& candidate, double x, double y, double size) {
    if (candidate.cell->judged())
        return fmt::format("M{:.1f} {:.1f}h{:.1f}v{:.1f}h{:.1f}z", x - size, y - size, 2 * size, 2 * size,
                           -2 * size);
    if (candidate.cell->algorithm == "gjk")
        return fmt::format("M{:.1f} {:.1f}l{:.1f} {:.1f}h{:.1f}z", x, y - size, size, 1.8 * size, -2 * size);
    return fmt::format("M{0:.1f} {1:.1f}a{2:.1f} {2:.1f} 0 1 0 {3:.1f} 0a{2:.1f} {2:.1f} 0 1 0 {4:.1f} 0z",
                       x - size, y, size, 2 * size, -2 * size);
}

}  // namespace

std::string mark_text(const Candidate& candidate) {
    std::string text = fmt::format("{}: {}", candidate.name(), ratio_text(candidate));
    if (candidate.worst_error) append(text, "error " + number_text(*candidate.worst_error, "scale"));
    if (candidate.bytes_per_edge)
        append(text, number_text(*candidate.bytes_per_edge, "B/edge") + " bytes per edge");
    return text;
}

std::string mark_svg(const Candidate& candidate, double x, double y, double size) {
    const std::string_view colour = store::layout_colour(candidate.cell->layout);
    return fmt::format("<path d=\"{}\" {}><title>{}</title></path>", outline(candidate, x, y, size),
                       candidate.meets_error
                           ? fmt::format("fill=\"{}\" fill-opacity=\".8\"", colour)
                           : fmt::format("fill=\"none\" stroke=\"{}\" stroke-opacity=\".8\"", colour),
                       html_text(mark_text(candidate)));
}

}  // namespace edgewise::reports
