// SPDX-License-Identifier: MIT
//
// A campaign's figures, for people and as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "edgewise/studies/campaign/cells.hpp"
#include "edgewise/studies/campaign/progress_file.hpp"

namespace edgewise::cli {

/// A row per family and one per cell. `cells` may be empty: then who answers as well is not said.
void print_campaign(const studies::campaign::CampaignProgress& progress,
                    std::span<const studies::campaign::Cell> cells, const std::string& state);
[[nodiscard]] nlohmann::json campaign_json(const studies::campaign::CampaignProgress& progress,
                                           std::span<const studies::campaign::Cell> cells);

}  // namespace edgewise::cli
