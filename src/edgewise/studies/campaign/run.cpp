// SPDX-License-Identifier: MIT
#include "edgewise/studies/campaign/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "edgewise/measure/stopwatch.hpp"

namespace edgewise::studies::campaign {

bool run_campaign(const PairSource& source, std::span<const Cell> cells, CampaignProgress& progress,
                  const CampaignHooks& hooks, const std::atomic<bool>& stop) {
    BlockRun blocks(cells);
    const Question& question = progress.question;
    const std::uint64_t first = question.shard.first_of(question.blocks());
    progress.next_block = std::max(progress.next_block, first);
    while (!progress.is_done()) {
        if (stop) return false;
        const measure::Stopwatch watch;
        const std::uint64_t block = progress.next_block;
        blocks.run(source, block, question.pairs_of(block), progress.tally, hooks.on_failure);
        ++progress.next_block;
        progress.seconds += watch.elapsed_ns() / 1e9;
        hooks.on_block(progress);
    }
    return true;
}

CampaignProgress added_up(std::span<const CampaignProgress> parts) {
    if (parts.empty())
        throw std::invalid_argument("no parts of a campaign; name the files that --state wrote");
    CampaignProgress whole;
    whole.question = parts.front().question;
    whole.question.shard = {};
    whole.next_block = whole.question.blocks();
    std::set<std::uint64_t> seen;
    for (const CampaignProgress& part : parts) {
        const sweep::Shard& shard = part.question.shard;
        if (!part.question.is_part_of_same(parts.front().question) ||
            shard.count != parts.front().question.shard.count)
            throw std::invalid_argument(
                "parts of different campaigns: seed, pairs, families, cells or shards differ");
        if (!seen.insert(shard.index).second)
            throw std::invalid_argument("shard " + shard.text() + " comes twice");
        whole.tally.add(part.tally);
        whole.seconds += part.seconds;
        if (!part.is_done()) whole.next_block = 0;
    }
    if (seen.size() < parts.front().question.shard.count) whole.next_block = 0;
    return whole;
}

}  // namespace edgewise::studies::campaign
