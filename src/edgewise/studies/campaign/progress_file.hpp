// SPDX-License-Identifier: MIT
//
// How far a campaign is: its question, the next block, and the tally. A JSON file of some kilobytes for any
// number of pairs. It is written to a temporary file and renamed, so that it is whole at any moment.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

}  // namespace edgewise::studies::campaign
