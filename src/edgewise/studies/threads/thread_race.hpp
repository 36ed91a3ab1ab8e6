// SPDX-License-Identifier: MIT
//
// Threads that each ask a cell of their own at the same time: copies of one workload and of its tables.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "edgewise/studies/single_cell.hpp"

namespace edgewise::studies {

/// A cell's workload and tables once more, with nothing in common with another copy.
class CellCopy {
  public:
    /// Throws std::invalid_argument as SingleCell.
    CellCopy(const SingleCell& cell, const bench::RunnerOptions& options);

    [[nodiscard]] bench::ThreadedPass& pass() const { return *pass_; }

  private:
    std::unique_ptr<scene::Workload> workload_;
    sweep::PreparedCell cell_;
    std::unique_ptr<bench::ThreadedPass> pass_;
};

struct TimedPass {
    double ns = 0;
    double sum = 0;  ///< as ThreadedPass::sum
};

/// One pass of this one in so many threads, after one that fills caches.
[[nodiscard]] TimedPass time_shared(bench::ThreadedPass& pass, int threads);

/// One pass of each copy, in as many threads. Nobody's is timed before all have made one, and who is done
/// goes on until all are: the others are at work from its beginning to its end.
[[nodiscard]] std::vector<TimedPass> time_apart(std::span<const CellCopy> copies);

}  // namespace edgewise::studies
