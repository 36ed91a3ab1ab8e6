// SPDX-License-Identifier: MIT
//
// What a citation of one figure takes: its picture as PDF beside the SVG, the points that it draws as CSV,
// and a text with the commands that made it. Of charts with a number alone (Chart::figure).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "edgewise/reports/page/pictures.hpp"

namespace edgewise::reports {

/// Writes figures/NAME.csv, NAME.txt and, where there is an SVG and rsvg-convert can, NAME.pdf below `out`;
/// old ones are removed. The same store gives the same bytes. Returns why a PDF is missing, in one line;
/// empty where none is.
std::string write_paper_figures(const ReportData& data, const std::vector<Chart>& charts,
                                const StaticPictures& pictures, const std::filesystem::path& out);

/// The points that a chart draws: a row each, a column for every member that one of them has.
[[nodiscard]] std::string points_csv(const ChartJson& points);

}  // namespace edgewise::reports
