// SPDX-License-Identifier: MIT
//
// The files for citing one figure: its picture as PDF next to the SVG, its points as CSV,
// and a text with the commands that made it. Only for charts with a number (Chart::figure).
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

/// Returns the points of a chart as CSV: a row each, and a column for every member that a point has.
[[nodiscard]] std::string points_csv(const ChartJson& points);

}  // namespace edgewise::reports
