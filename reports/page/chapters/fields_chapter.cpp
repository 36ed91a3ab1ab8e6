// SPDX-License-Identifier: MIT
#include "edgewise/reports/page/chapters/fields_chapter.hpp"

#include "edgewise/reports/tables/field_tables.hpp"
#include "edgewise/reports/text/report_text.hpp"

namespace edgewise::reports {

std::optional<Chapter> fields_chapter(const ReportData& data) {
    if (data.fields.empty()) return std::nullopt;
    Chapter chapter{.id = "fields",
                    .title = "Which fields travel together?",
                    .paragraph = prose("fields.md") + field_verdict(data),
                    .blocks = {{.grids = {field_advice_grid(data)}}},
                    .link = "Fields"};
    for (const ReportCell& row : data.fields) {
        if (!row.verified()) continue;
        chapter.blocks.push_back({.elements = "<div class=\"wide\">" + field_picture(row) + "</div>\n",
                                  .grids = {field_groups_grid(row)},
                                  .fold = row.table + ", " + row.algorithm + ": matrix and records"});
    }
    return chapter;
}

}  // namespace edgewise::reports
