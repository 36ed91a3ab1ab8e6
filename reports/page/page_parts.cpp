// SPDX-License-Identifier: MIT
//
// See page_parts.hpp.
#include "edgewise/reports/page/page_parts.hpp"

#include <fmt/core.h>

#include "edgewise/reports/page/bundles.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

std::string picture_html(const Chart& chart, const StaticPictures& pictures) {
    const auto svg = pictures.svg.find(chart.name);
    return svg != pictures.svg.end() ? svg->second : grid_html(chart.fallback);
}

}  // namespace

std::string html_chart(const Chart& chart, const StaticPictures& pictures, bool alive,
                       const std::string& level) {
    std::string out = fmt::format("<{0}>{1}</{0}>\n", level, html_text(chart.title));
    out += html_paragraph(chart.how_to_read);
    if (chart.spec.is_null()) {
        out += html_paragraph("Nothing to draw: no cell has the figures of this chart.", "note");
    } else {
        out += fmt::format("<div class=\"chart\"><div id=\"chart-{}\">\n{}</div></div>\n", chart.name,
                           picture_html(chart, pictures));
        if (alive)
            out += fmt::format(
                "<script type=\"application/json\" data-chart=\"{}\">{}</script>\n", chart.name,
                inline_json(chart.spec.dump(-1, ' ', false, ChartJson::error_handler_t::replace)));
    }
    for (const std::string& note : chart.notes) out += html_paragraph(note, "note");
    return out;
}

std::string html_paragraph(const std::string& text, const std::string& style) {
    return fmt::format("<p{}>{}</p>\n", style.empty() ? "" : " class=\"" + style + "\"", html_text(text));
}

std::string html_heading(const std::string& id, const std::string& text) {
    return fmt::format("<h2 id=\"{}\">{}</h2>\n", id, html_text(text));
}

std::string html_folded(const std::string& summary, const std::string& inside) {
    return fmt::format("<details><summary>{}</summary>\n{}</details>\n", html_text(summary), inside);
}

std::string markdown_chart(const Chart& chart, const StaticPictures& pictures, const std::string& level) {
    std::string out = fmt::format("{} {}\n\n{}\n\n", level, chart.title, chart.how_to_read);
    if (pictures.svg.count(chart.name))
        out += fmt::format("![{}](figures/{}.svg)\n\n", chart.title, chart.name);
    for (const std::string& note : chart.notes) out += "- " + markdown_text(note) + "\n";
    if (!chart.notes.empty()) out += "\n";
    return out;
}

}  // namespace edgewise::reports
