// SPDX-License-Identifier: MIT
//
// A campaign: as many pairs as wanted, block after block, from where its file says that it was left.
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

/// Goes on until the shard is done or `stop` is set; false if that came first.
bool run_campaign(const PairSource& source, std::span<const Cell> cells, CampaignProgress& progress,
                  const CampaignHooks& hooks, const std::atomic<bool>& stop);

/// Parts of one campaign as one. Throws std::invalid_argument, one line, for parts of different campaigns and
/// for a shard that comes twice.
[[nodiscard]] CampaignProgress added_up(std::span<const CampaignProgress> parts);

}  // namespace edgewise::studies::campaign
