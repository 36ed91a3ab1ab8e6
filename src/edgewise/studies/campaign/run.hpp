// SPDX-License-Identifier: MIT
//
// Runs a campaign of any number of pairs, block after block, from the place where its file says it stopped.
#pragma once

#include <atomic>
#include <functional>
#include <span>

#include "edgewise/studies/campaign/block_run.hpp"
#include "edgewise/studies/campaign/progress_file.hpp"

namespace edgewise::studies::campaign {

struct CampaignHooks {
    std::function<void(const CampaignProgress&)> on_block = [](const CampaignProgress&) {};
    std::function<void(const Failure&)> on_failure = [](const Failure&) {};
};

/// Goes on until the shard is done or `stop` is set; returns false if `stop` came first.
bool run_campaign(const PairSource& source, std::span<const Cell> cells, CampaignProgress& progress,
                  const CampaignHooks& hooks, const std::atomic<bool>& stop);

/// Adds up parts of one campaign. Throws std::invalid_argument, one line, for parts of different campaigns
/// and for a shard that comes twice.
[[nodiscard]] CampaignProgress added_up(std::span<const CampaignProgress> parts);

}  // namespace edgewise::studies::campaign
