// SPDX-License-Identifier: MIT
//
// The results of a sweep that a store already has from one build: a stopped sweep continues from them.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/store/store.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/sweep/prepared_cell.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

/// Returns the seconds that a group or another run last took, in any build; nothing if none are stored.
[[nodiscard]] std::optional<double> took_in(const store::Store& store, const std::string& what);

/// Returns the seconds of everything that ran into the store at this path, by name.
[[nodiscard]] std::map<std::string, double> seconds_in(const std::string& store);

/// The `run` of the plan's cells in this process.
[[nodiscard]] std::string run_of(const Plan& plan);

/// Keeps, of each scene and body, the baseline and the algorithms on table types that are fast in their
/// precision (store::fast_ratio), by what this build stored in the first process.
void keep_finalists(SweepWork& work, const std::string& store);

class StoredCells {
  public:
    /// Keeps the store and the plan.
    StoredCells(store::Store& store, std::string build, const Plan& plan)
        : store_(store), build_(std::move(build)), plan_(plan) {}

    /// Returns the status of a cell if the store has all its results: figures, rounds, and the checked
    /// answers and modelled caches that this plan orders. Otherwise nothing.
    [[nodiscard]] std::optional<store::CellStatus> status_of(const CellRun& cell) const;

    /// Returns the numbers of the rounds that do not have the cell's time.
    [[nodiscard]] std::set<int> rounds_missing(const CellRun& cell) const;
    [[nodiscard]] std::vector<measure::Round> rounds_of(const CellRun& cell) const {
        return store_.rounds(build_, cell.row().hash);
    }

    [[nodiscard]] std::optional<double> took(const std::string& group) const {
        return took_in(store_, name_of_time(group));
    }

    /// Figures of probes that this plan leaves out stay as an earlier run measured them.
    void put(const CellRun& cell);
    void put(std::span<const std::pair<std::string, measure::Round>> round) {
        store_.put_round(build_, round);
    }
    /// Stores the cell's heat on the body, and the body. Stores nothing if the cell has no heat.
    void put_heat(const CellRun& cell, const Polyhedron& body);
    void put_seconds(const std::string& of, double seconds);
    /// Stores what others took of the processor while the cells of one scene and shape were timed, unless
    /// more is stored.
    void put_others(const store::CellRow& of, double share);

  private:
    /// Returns true if an earlier run checked fewer answers of the cell than this plan orders.
    [[nodiscard]] bool lacks_checks(const store::StoredCell& stored) const;
    /// Returns true if an earlier run left out probes that this plan has (--probes).
    [[nodiscard]] bool lacks_probes(const store::StoredCell& stored) const;

    /// Times of a further process are not those of the sweep.
    [[nodiscard]] std::string name_of_time(const std::string& of) const {
        return plan_.process == 1 ? of : run_of(plan_) + " " + of;
    }

    store::Store& store_;
    std::string build_;
    const Plan& plan_;
};

}  // namespace edgewise::sweep
