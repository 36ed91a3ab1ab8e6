// SPDX-License-Identifier: MIT
//
// How far a campaign is: what was asked for, the next block, and the tally. A JSON file of some kilobytes,
// however many pairs; written beside itself and renamed, so that it is whole at any moment.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/studies/campaign/tally.hpp"
#include "edgewise/sweep/shard.hpp"

namespace edgewise::studies::campaign {

/// What decides which pairs are asked of whom. Parts of one campaign have all but the shard in common.
struct Question {
    std::uint64_t seed = 1, pairs = 0;
    std::vector<std::string> families;  ///< in turn
    std::vector<std::string> cells;
    sweep::Shard shard;

    [[nodiscard]] std::uint64_t blocks() const;
    /// Of the last block fewer may be asked.
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
    /// Asked so far.
    [[nodiscard]] std::uint64_t pairs() const;
};

void write_progress(const CampaignProgress& progress, const std::string& path);

/// Nothing where there is no such file; throws std::invalid_argument, one line, where it is none of these.
[[nodiscard]] std::optional<CampaignProgress> read_progress(const std::string& path);

[[nodiscard]] nlohmann::json to_json(const CampaignProgress& progress);

}  // namespace edgewise::studies::campaign
