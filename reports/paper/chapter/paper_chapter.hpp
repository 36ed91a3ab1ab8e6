// SPDX-License-Identifier: MIT
//
// The chapter on the paper's figures: what it shows, in which order, once for the page and for Markdown. It
// is there when the store holds scenes from files.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/page/pictures.hpp"
#include "edgewise/reports/reader.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// One part: a paragraph, then its charts, then its grids; one without charts and rows is left out.
struct ChapterPart {
    std::string title, paragraph;
    std::string section;                      ///< of its charts (paper_charts.hpp); empty: it has none
    std::vector<TextGrid> grids, long_grids;  ///< in full view; folded
};

[[nodiscard]] bool has_paper_chapter(const ReportData& data);
[[nodiscard]] std::string paper_chapter_title(const ReportData& data);
/// Grids that stand before all parts: the paper's claims and how they fare. To add one, name it here.
[[nodiscard]] std::vector<TextGrid> opening_grids(const ReportData& data);
[[nodiscard]] std::vector<ChapterPart> chapter_parts(const ReportData& data);

/// Empty without scenes from files.
[[nodiscard]] std::string paper_chapter_html(const ReportData& data, const std::vector<Chart>& charts,
                                             const StaticPictures& pictures, bool alive);
[[nodiscard]] std::string paper_chapter_markdown(const ReportData& data, const std::vector<Chart>& charts,
                                                 const StaticPictures& pictures);

}  // namespace edgewise::reports
