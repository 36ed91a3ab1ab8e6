// SPDX-License-Identifier: MIT
//
// Static pictures of the charts: each specification becomes figures/NAME.svg by node, with the same bundles
// that the page uses. Optional: without node or bundles the page shows small tables instead, and says so. And
// the files for citing a figure: its picture as PDF next to the SVG, its points as CSV, and a text with the
// commands that made it.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"

namespace edgewise::reports {

struct StaticPictures {
    std::map<std::string, std::string> svg;    ///< by chart name
    std::map<std::string, std::string> still;  ///< likewise, small enough for the page (most_still_bytes)
    std::string note;                          ///< why some or all are missing; empty when none is
};

inline constexpr std::size_t most_still_bytes = 20000;

/// Writes figures/NAME.vl.json for every chart and, where node can, figures/NAME.svg; old pictures are
/// removed. `tables`: the few table types that a still picture shows where all would be too many.
[[nodiscard]] StaticPictures write_pictures(const std::vector<Chart>& charts,
                                            const std::set<std::string>& tables,
                                            const std::filesystem::path& out,
                                            const std::filesystem::path& bundles);

/// Writes figures/NAME.csv, NAME.txt and, where there is an SVG and rsvg-convert can, NAME.pdf below `out`;
/// old ones are removed. The same store gives the same bytes. Returns why a PDF is missing, in one line;
/// empty where none is.
std::string write_cited_figures(const ReportData& data, const std::vector<Chart>& charts,
                                const StaticPictures& pictures, const std::filesystem::path& out);

/// Returns the points of a chart as CSV: a row each, and a column for every member that a point has.
[[nodiscard]] std::string points_csv(const ChartJson& points);

}  // namespace edgewise::reports
