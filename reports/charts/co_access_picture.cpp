// SPDX-License-Identifier: MIT
#include "edgewise/reports/charts/co_access_picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/store/palette.hpp"

namespace edgewise::reports {

namespace {

constexpr int square = 26, left_margin = 118, top_margin = 150, letter_width = 6;

int at(std::size_t place) { return static_cast<int>(place) * square; }

/// A square, its number in hundredths, and what it means when pointed at.
std::string cell(std::size_t row, std::size_t column, double part, const std::string& what) {
    const int x = left_margin + at(column), y = top_margin + at(row);
    return fmt::format(
        "<g><title>{}: {:.3f}</title><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" "
        "fill-opacity=\"{:.3f}\"/><text x=\"{}\" y=\"{}\" text-anchor=\"middle\" font-size=\"9\">{:.0f}</text></g>\n",
        html_text(what), part, x, y, square - 1, square - 1, store::component_colour("voronoi_planes"),
        0.75 * part, x + square / 2, y + square / 2 + 3, 100 * part);
}

std::string labels(std::span<const CoAccessField> fields) {
    std::string text;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::string name = html_text(fields[i].name);
        const int middle = at(i) + square / 2;
        text += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>\n", left_margin - 6,
                            top_margin + middle + 4, name);
        text += fmt::format("<text transform=\"translate({},{}) rotate(-60)\">{}</text>\n",
                            left_margin + middle + 4, top_margin - 6, name);
    }
    return text;
}

/// Around the fields of each record.
std::string frames(std::span<const CoAccessField> fields) {
    std::string text;
    for (std::size_t first = 0; first < fields.size();) {
        std::size_t last = first + 1;
        while (last < fields.size() && fields[last].record == fields[first].record) ++last;
        text += fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"currentColor\"/>\n",
            left_margin + at(first), top_margin + at(first), at(last - first) - 1, at(last - first) - 1);
        first = last;
    }
    return text;
}

}  // namespace

std::string draw_co_access(const std::string& title, std::span<const CoAccessField> fields,
                           const CoAccessParts& by_query, const CoAccessParts& by_step) {
    std::string body;
    for (std::size_t row = 0; row < fields.size(); ++row)
        for (std::size_t column = 0; column < fields.size(); ++column) {
            const bool of_query = column > row;
            const std::string& a = fields[row].name;
            const std::string what = row == column ? fmt::format("steps that read {}", a)
                                                   : fmt::format("{} and {}, same {}", a, fields[column].name,
                                                                 of_query ? "query" : "step");
            body += cell(row, column, (of_query ? by_query : by_step)[row][column], what);
        }
    const std::string caption =
        "hundredths of what reads either field; above the diagonal same query, below same step, framed: a record";
    const int side = at(fields.size()), letters = static_cast<int>(std::max(title.size(), caption.size()));
    const int width = std::max(left_margin + side + 60, 16 + letters * letter_width);
    const int height = top_margin + side + 12;
    const std::string start = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" ",
        width, height);
    const std::string style = "font-family=\"sans-serif\" font-size=\"11\" fill=\"currentColor\">\n";
    const std::string heading = fmt::format(
        "<title>{0}</title>\n<text x=\"8\" y=\"16\" font-weight=\"bold\">{0}</text>\n", html_text(title));
    return start + style + heading + fmt::format("<text x=\"8\" y=\"32\">{}</text>\n", caption) + body +
           labels(fields) + frames(fields) + "</svg>\n";
}

}  // namespace edgewise::reports
