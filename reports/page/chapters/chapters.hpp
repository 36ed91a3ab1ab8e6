// SPDX-License-Identifier: MIT
//
// The report's chapters: one question each, in its reader's words. This folder decides the content and order
// of each.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"
#include "edgewise/reports/charts/charts.hpp"
#include "edgewise/reports/tables/text_grid.hpp"

namespace edgewise::reports {

/// A part of a chapter after its paragraph, in the order of the members.
struct ChapterBlock {
    std::string title = {}, paragraph = {};
    std::string section = {};          ///< not empty: the charts of this section
    std::string elements = {};         ///< of the page, before the grids
    std::vector<TextGrid> grids = {};  ///< long ones show their first rows, and all on demand
    std::string fold = {};             ///< not empty: made when this line is opened
};

struct Chapter {
    std::string id, title;
    std::string paragraph = {};  ///< how to read what follows
    std::vector<ChapterBlock> blocks = {};
    std::string link = {};      ///< its name where the page lists all chapters; the title where empty
    std::string sentence = {};  ///< answer to its question from the store, with figures; shown first
};

[[nodiscard]] std::vector<Chapter> report_chapters(const Answer& answer, const ReportData& data,
                                                   const std::vector<Chart>& charts);

/// Chapters of the studies without one of their own, by name: one grid each, as the store describes it.
[[nodiscard]] std::vector<Chapter> study_chapters(const ReportData& data);

}  // namespace edgewise::reports
