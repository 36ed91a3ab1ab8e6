// SPDX-License-Identifier: MIT
//
// What a store already has of a sweep, of one build: a sweep that was stopped goes on from there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/store/store.hpp"
#include "edgewise/sweep/cell_run.hpp"

namespace edgewise::sweep {

class StoredCells {
  public:
    /// rounds: how many the plan asks for.
    StoredCells(store::Store& store, std::string build, int rounds)
        : store_(store), build_(std::move(build)), rounds_(rounds) {}

    /// The status of a cell of which everything is there: figures, rounds, and caches as ordered now.
    [[nodiscard]] std::optional<std::string> status_of(const CellRun& cell) const;

    /// Numbers of the rounds that the cell has not been timed in.
    [[nodiscard]] std::vector<int> rounds_missing(const CellRun& cell) const;

    [[nodiscard]] std::vector<measure::Round> rounds_of(const CellRun& cell) const {
        return store_.rounds(build_, cell.row().hash);
    }

    void put(const CellRun& cell) { store_.put_cell(build_, cell.row(), cell.figures()); }
    void put(std::span<const std::pair<std::string, measure::Round>> round) {
        store_.put_round(build_, round);
    }

  private:
    /// An earlier run may not have modelled these machines, or fewer queries.
    [[nodiscard]] bool lacks_caches(const CellRun& cell) const;

    store::Store& store_;
    std::string build_;
    int rounds_;
};

}  // namespace edgewise::sweep
