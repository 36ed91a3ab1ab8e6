// SPDX-License-Identifier: MIT
//
// A part of a campaign: shard i of n, counted from 1, takes one range of blocks in a row. The ranges of all
// shards are the whole, each block once.
#pragma once

#include <cstdint>
#include <string>

#include "edgewise/geometry/result.hpp"

namespace edgewise::studies::campaign {

struct Shard {
    std::uint64_t index = 1, count = 1;

    /// "3/8"; an error says what was wrong with it.
    [[nodiscard]] static Result<Shard> parse(const std::string& text);

    /// Blocks first(blocks) .. last(blocks) - 1 of so many are this shard's.
    [[nodiscard]] std::uint64_t first(std::uint64_t blocks) const { return part(blocks, index - 1); }
    [[nodiscard]] std::uint64_t last(std::uint64_t blocks) const { return part(blocks, index); }

    [[nodiscard]] bool operator==(const Shard&) const = default;

  private:
    /// blocks * i / count without overflow.
    [[nodiscard]] std::uint64_t part(std::uint64_t blocks, std::uint64_t i) const {
        return blocks / count * i + blocks % count * i / count;
    }
};

}  // namespace edgewise::studies::campaign
