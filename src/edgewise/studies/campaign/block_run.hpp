// SPDX-License-Identifier: MIT
//
// Runs one block of pairs through every cell: asks, proves and tallies. Every pair is asked twice: cold, and
// warm, in time order, with the pair's cache kept from pose to pose.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "edgewise/studies/campaign/cells.hpp"
#include "edgewise/studies/campaign/pair_source.hpp"
#include "edgewise/studies/campaign/tally.hpp"

namespace edgewise::studies::campaign {

/// A wrong answer and where to find it again.
struct Failure {
    std::uint64_t pair = 0;
    std::string cell, family, what;
};

/// Bodies that some cells store with equal values, and the exact answers known for their pairs.
struct BlockStorage {
    std::span<const Polyhedron> bodies;
    truth::StoredPair pair;
    std::vector<truth::ProvenPair> known;
    bool counts = false;  ///< the first: its pairs are counted by verdict
};

/// A cell's two askers: one for cold pairs, one for warm ones.
struct ColdAndWarm {
    std::unique_ptr<Asker> cold, warm;
};

class BlockRun {
  public:
    /// Keeps the cells.
    explicit BlockRun(std::span<const Cell> cells);

    /// Adds the first `count` pairs of a block to the tally; reports every wrong answer.
    void run(const PairSource& source, std::uint64_t block, std::uint64_t count, Tally& tally,
             const std::function<void(const Failure&)>& on_failure);

  private:
    void load(const scene::Workload& cold, const scene::Workload& warm);
    [[nodiscard]] std::size_t storage_of(std::span<const Polyhedron> stored);
    void ask(std::size_t cell, bool warm, const Block& block, FamilyTally& family, CellTally& tally);

    std::span<const Cell> cells_;
    std::vector<ColdAndWarm> askers_;
    std::vector<std::string> refusals_;  ///< by cell: why it cannot hold the block's bodies
    std::vector<BlockStorage> storages_;
    std::vector<std::size_t> storage_;  ///< by cell
    std::vector<Failure> failures_;
    std::uint64_t block_ = 0;
};

}  // namespace edgewise::studies::campaign
