// SPDX-License-Identifier: MIT
//
// Shards of a sweep: its comparisons and its other runs are divided among a number of shards. A comparison is
// the cells of one scene and shape; they are timed in turns, so they stay in one shard. Every process
// computes the same division from the plan alone, so processes need no communication.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "edgewise/geometry/result.hpp"

namespace edgewise::sweep {

/// Part `index` of `count`; 0 of 1 is the whole.
struct Shard {
    std::size_t index = 0, count = 1;

    [[nodiscard]] bool is_whole() const { return count == 1; }
    /// This shard has pieces first_of(pieces) .. last_of(pieces) - 1 of a row; each piece is in one shard.
    [[nodiscard]] std::size_t first_of(std::size_t pieces) const { return start_of(pieces, index); }
    [[nodiscard]] std::size_t last_of(std::size_t pieces) const { return start_of(pieces, index + 1); }
    [[nodiscard]] bool operator==(const Shard&) const = default;
    [[nodiscard]] std::string text() const;  ///< "3/8"

  private:
    /// pieces * i / count without overflow.
    [[nodiscard]] std::size_t start_of(std::size_t pieces, std::size_t i) const {
        return pieces / count * i + pieces % count * i / count;
    }
};

/// Returns the value of an environment variable; null if it is not set.
using Environment = std::function<const char*(const char* name)>;

/// Parses "3/8"; "auto/8", with the index from the scheduler's environment variable; or "auto", with the
/// count from the environment, too. Variables that count from 0: SLURM_ARRAY_TASK_ID, JOB_COMPLETION_INDEX,
/// OMPI_COMM_WORLD_RANK and PBS_ARRAY_INDEX; from 1: SGE_TASK_ID and PARALLEL_SEQ.
[[nodiscard]] Result<Shard> parse_shard(const std::string& text, const Environment& environment);

/// A unit of work that one shard gets as a whole.
struct ShardUnit {
    std::string name;  ///< unique, and the same in every process
    double cost = 0;   ///< predicted, in any unit
};

/// Replaces costs by seconds of an earlier run (by name). Other costs are scaled to seconds in proportion.
void weigh(std::span<ShardUnit> units, const std::map<std::string, double>& seconds);

/// Returns the positions of the shard's units, in ascending order. Units are assigned in order of falling
/// cost, each to the shard with the least cost so far; among equal costs a hash of the names decides.
[[nodiscard]] std::vector<std::size_t> dealt_to(const Shard& shard, std::span<const ShardUnit> units);

/// Weighs the units and returns the names of the shard's units.
[[nodiscard]] std::set<std::string> names_dealt_to(const Shard& shard, std::vector<ShardUnit> units,
                                                   const std::map<std::string, double>& seconds);

}  // namespace edgewise::sweep
