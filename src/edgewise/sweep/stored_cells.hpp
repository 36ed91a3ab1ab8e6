// SPDX-License-Identifier: MIT
//
// What a store already has of a sweep, of one build: a sweep that was stopped goes on from there.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/store/store.hpp"
#include "edgewise/sweep/cell_run.hpp"
#include "edgewise/sweep/plan.hpp"

namespace edgewise::sweep {

/// Seconds that a group or another run took when it last ran, of any build; nothing where none are stored.
[[nodiscard]] std::optional<double> took_in(const store::Store& store, const std::string& what);

/// Seconds of everything that ran into the store at this path, by name.
[[nodiscard]] std::map<std::string, double> seconds_in(const std::string& store);

class StoredCells {
  public:
    StoredCells(store::Store& store, std::string build, const Plan& plan)
        : store_(store), build_(std::move(build)), rounds_(plan.rounds), checked_(plan.checked) {}

    /// The status of a cell of which everything is there: figures, rounds, as many checked answers and caches
    /// as ordered now.
    [[nodiscard]] std::optional<store::CellStatus> status_of(const CellRun& cell) const;

    /// Numbers of the rounds that the cell has not been timed in.
    [[nodiscard]] std::set<int> rounds_missing(const CellRun& cell) const;
    [[nodiscard]] std::vector<measure::Round> rounds_of(const CellRun& cell) const {
        return store_.rounds(build_, cell.row().hash);
    }

    [[nodiscard]] std::optional<double> took(const std::string& group) const {
        return took_in(store_, group);
    }

    void put(const CellRun& cell) { store_.put_cell(build_, cell.row(), cell.figures()); }
    void put(std::span<const std::pair<std::string, measure::Round>> round) {
        store_.put_round(build_, round);
    }
    /// Its heat on the body, and the body; of a cell that has none nothing.
    void put_heat(const CellRun& cell, const Polyhedron& body);
    void put_seconds(const std::string& of, double seconds);

  private:
    /// An earlier run may have checked fewer answers: the cell is not verified as it is asked to be now.
    [[nodiscard]] bool lacks_checks(const store::CellRow& row,
                                    std::span<const store::FigureRow> stored) const;

    store::Store& store_;
    std::string build_;
    int rounds_;
    std::size_t checked_;
};

}  // namespace edgewise::sweep
