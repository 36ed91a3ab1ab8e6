// SPDX-License-Identifier: MIT
//
// Static pictures of the charts: each specification becomes figures/NAME.svg by node, with the same bundles
// that the page uses. Optional: without node or bundles the page shows small tables instead, and says so.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "edgewise/reports/charts/charts.hpp"

namespace edgewise::reports {

struct StaticPictures {
    std::map<std::string, std::string> svg;  ///< by chart name
    std::string note;                        ///< why some or all are missing; empty when none is
};

/// Writes figures/NAME.vl.json for every chart and, where node can, figures/NAME.svg; old pictures are
/// removed.
[[nodiscard]] StaticPictures write_pictures(const std::vector<Chart>& charts,
                                            const std::filesystem::path& out,
                                            const std::filesystem::path& bundles);

}  // namespace edgewise::reports
