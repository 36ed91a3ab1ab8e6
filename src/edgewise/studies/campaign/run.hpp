// SPDX-License-Identifier: MIT
//
// Runs a campaign of any number of pairs, block after block, from the place where its file says it stopped.
#pragma once

#include <atomic>
#include <functional>
#include <span>
#include <string>

#include "edgewise/scene/case_file.hpp"
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

// Writes a wrong answer as a line of a case file, which the corpus takes and `edgewise query` answers.

/// Returns the pair as its source made it.
[[nodiscard]] scene::Case case_of(const PairSource& source, std::uint64_t pair);

/// Returns why the cell's answer to the case is wrong; empty if it is right or there is none.
[[nodiscard]] std::string what_is_wrong(const scene::Case& of, const Cell& cell);

/// Minimises the failing pair; returns a line that says which answer to which pair was wrong, and how.
[[nodiscard]] std::string failing_line(const PairSource& source, const Failure& failure, const Cell& cell);

}  // namespace edgewise::studies::campaign
