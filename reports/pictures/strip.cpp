// SPDX-License-Identifier: MIT
#include "edgewise/reports/pictures/strip.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/pictures/log_scale.hpp"
#include "edgewise/reports/pictures/marks.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

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

std::string strip_opening(const std::string& label) {
    return fmt::format("<svg class=\"strip\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">",
                       strip_width, strip_height, html_text(label));
}

std::string strip_label(const SceneRanking& scene) {
    const RankedCell* choice = scene.choice();
    const RankedCell &first = scene.cells.front(), &last = scene.cells.back();
    std::string text = fmt::format("{} on an axis of time over the baseline's, from {:.2f} to {:.2f}",
                                   plural(scene.cells.size(), "table type"), first.ratio, last.ratio);
    return choice ? fmt::format("{}: {}. {}", choice->name(), ratio_text(*choice), text) : text;
}

}  // namespace

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
    std::string svg = strip_opening(strip_label(scene));
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

}  // namespace edgewise::reports
