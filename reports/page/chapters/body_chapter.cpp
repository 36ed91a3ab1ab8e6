// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/chapters/body_chapter.hpp"

#include <fmt/core.h>

#include "edgewise/reports/body/body_picture.hpp"
#include "edgewise/reports/page/html.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

Chapter body_chapter(const Answer&, const ReportData& data) {
    Chapter chapter{.id = "body", .title = "Where on the body is the work?", .link = "The body"};
    const HeatOnBodies found = heat_on_bodies(data);
    if (found.heats.empty()) {
        chapter.paragraph = prose("no_body.md");
        return chapter;
    }
    const BodyHeat& first = found.heats.front();
    std::string options;
    for (std::size_t i = 0; i < found.heats.size(); ++i)
        options += html_option(std::to_string(i), found.heats[i].title(), i == 0);
    chapter.paragraph = prose("body.md");
    chapter.blocks = {
        {.elements = fmt::format(fmt::runtime(report_text("page.body.html")),
                                 fmt::arg("choice", html_select("body-cell", "reads of", options)),
                                 fmt::arg("title", html_text(first.title())),
                                 fmt::arg("svg", body_svg(found.bodies.at(first.cell->shape), first)),
                                 fmt::arg("said", html_text(first.sentence())))}};
    return chapter;
}

}  // namespace edgewise::reports
