// SPDX-License-Identifier: MIT
//
// Runs a campaign of any number of pairs, block after block, from the place where its file says it stopped.
//
// How far a campaign is: its question, the next block, and the tally. A JSON file of some kilobytes for any
// number of pairs. It is written to a temporary file and renamed, so that it is whole at any moment.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "edgewise/scene/case_file.hpp"
#include "edgewise/studies/campaign/block_run.hpp"
#include "edgewise/sweep/shard.hpp"

namespace edgewise::studies::campaign {

/// Decides the pairs and the cells of a campaign. Parts of one campaign differ only in the shard.
struct Question {
    std::uint64_t seed = 1, pairs = 0;
    std::vector<std::string> families;  ///< in turn
    std::vector<std::string> cells;
    sweep::Shard shard;

    [[nodiscard]] std::uint64_t blocks() const;
    /// Returns how many pairs of a block are asked; the last block may have fewer.
    [[nodiscard]] std::uint64_t pairs_of(std::uint64_t block) const;
    [[nodiscard]] bool is_part_of_same(const Question& other) const;
    [[nodiscard]] bool operator==(const Question&) const = default;
};

struct CampaignProgress {
    Question question;
    std::uint64_t next_block = 0;
    double seconds = 0;  ///< of running so far
    Tally tally;

    [[nodiscard]] bool is_done() const { return next_block >= question.shard.last_of(question.blocks()); }
    /// Returns the number of pairs asked so far.
    [[nodiscard]] std::uint64_t pairs() const;
};

void write_progress(const CampaignProgress& progress, const std::string& path);

/// Returns nothing if there is no file; throws std::invalid_argument, one line, if it is no progress file.
[[nodiscard]] std::optional<CampaignProgress> read_progress(const std::string& path);

[[nodiscard]] nlohmann::json to_json(const CampaignProgress& progress);

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
