// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/chapters/chapters.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/answer/break_even_map.hpp"
#include "edgewise/reports/answer/decision.hpp"
#include "edgewise/reports/page/first_screen/first_screen.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/pictures/ranking_pictures.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

namespace {

/// The map and where its winner changes.
std::string break_even_html(const BreakEvenMap& map) {
    if (map.measured() == 0)
        return html_paragraph("No scene of this store was timed in the same rounds as the baseline.", "note");
    std::string html = html_paragraph(break_even_sentence(map), "sentence");
    html += "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"Who wins where, as a picture\">" +
            break_even_svg(map) + "</div>\n";
    html += html_paragraph(fmt::format("Within an error of {}.", limit_text(map.error_limit)), "note");
    return html + html_list(break_even_lines(map), "findings");
}

/// What the map has no room or no place for.
std::string left_out_text(const BreakEvenMap& map) {
    std::string text;
    if (map.columns_left_out > 0)
        append(text, plural(map.columns_left_out, "body", "bodies") + " of fewer scenes are left out", "; ");
    if (map.bodies_not_timed > 0)
        append(text, fmt::format("of {} nothing was timed", plural(map.bodies_not_timed, "body", "bodies")),
               "; ");
    if (map.scenes_left_out > 0)
        append(text, plural(map.scenes_left_out, "scene") + " without turn or number of tables as well",
               "; ");
    return text.empty() ? text : text + ".";
}

}  // namespace

Chapter break_even_chapter(const Answer& answer, const ReportData& data) {
    const BreakEvenMap map = break_even_map(data, answer.question.error_limit);
    Chapter chapter{
        .id = "map",
        .title = "From how many vertices, at which coherence and working set, does which layout win?",
        .paragraph = prose("break_even.md"),
        .link = "Who wins where"};
    chapter.blocks.push_back({.elements = "<div id=\"break-even\">" + break_even_html(map) + "</div>\n"});
    if (const std::string left_out = left_out_text(map); !left_out.empty())
        chapter.blocks.push_back({.paragraph = left_out});
    if (map.measured() > 0)
        chapter.blocks.push_back({.grids = {break_even_grid(map)}, .fold = "Every place as a table"});
    chapter.blocks.push_back({.paragraph = prose("break_even_plan.md")});
    return chapter;
}

std::string break_even_data(const ReportData& data) {
    nlohmann::ordered_json maps = nlohmann::ordered_json::object();
    for (const double limit : offered_limits)
        maps[limit_text(limit)] = break_even_html(break_even_map(data, limit));
    return input::json_text(maps);
}

}  // namespace edgewise::reports
