// SPDX-License-Identifier: MIT
//
// Static pictures of the charts: each specification becomes figures/NAME.svg by node, with the same bundles
// that the page uses. Optional: without node or bundles the page shows small tables instead, and says so.
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

}  // namespace edgewise::reports
