// SPDX-License-Identifier: MIT
//
// The report's chapters after the charts: what each holds and in which order, once for the page and for
// Markdown.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// What stands in a chapter after its paragraph, in the order of the members.
struct ChapterBlock {
    std::string title = {}, paragraph = {};
    std::string section = {};   ///< not empty: the charts of this section
    std::string elements = {};  ///< of the page, before the grids
    std::vector<TextGrid> grids = {};
    std::string fold = {};   ///< not empty: folded on the page under this line
    bool page_only = false;  ///< not for Markdown, which holds the same elsewhere or cannot show it
};

struct Chapter {
    std::string id, title, paragraph;
    std::vector<ChapterBlock> blocks;
    std::string link = {};  ///< its name where the page lists all chapters; the title where empty
};

[[nodiscard]] std::vector<Chapter> report_chapters(const ReportData& data, const std::vector<Chart>& charts);

}  // namespace edgewise::reports
