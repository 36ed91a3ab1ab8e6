// SPDX-License-Identifier: MIT
//
// A campaign in parts: its comparisons (the cells of one scene and shape, which are timed in turns and so
// stay together) and its other runs are dealt to so many shards. Every process deals alike, from the plan
// alone, so none talks to another.
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
    /// Of so many pieces in a row, its are first_of(pieces) .. last_of(pieces) - 1; each is some shard's.
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

/// Of the environment: null where there is no such variable.
using Environment = std::function<const char*(const char* name)>;

/// "3/8"; or "auto/8", whose index is what the scheduler says in the environment, and "auto", where that says
/// the count too. Known: SLURM_ARRAY_TASK_ID, JOB_COMPLETION_INDEX, OMPI_COMM_WORLD_RANK and PBS_ARRAY_INDEX,
/// which count from 0, SGE_TASK_ID and PARALLEL_SEQ, which count from 1.
[[nodiscard]] Result<Shard> parse_shard(const std::string& text, const Environment& environment);

/// What is dealt as one.
struct ShardUnit {
    std::string name;  ///< the same in every process, and of no other unit
    double cost = 0;   ///< predicted, in any unit
};

/// Costs in seconds where an earlier run tells them (by name), else in proportion.
void weigh(std::span<ShardUnit> units, const std::map<std::string, double>& seconds);

/// Places of the units that the shard has, in order. The dearest are dealt first, each to the shard that has
/// least so far; among equals a hash of the names decides.
[[nodiscard]] std::vector<std::size_t> dealt_to(const Shard& shard, std::span<const ShardUnit> units);

/// Weighs the units and returns the names of those that the shard has.
[[nodiscard]] std::set<std::string> names_dealt_to(const Shard& shard, std::vector<ShardUnit> units,
                                                   const std::map<std::string, double>& seconds);

}  // namespace edgewise::sweep
