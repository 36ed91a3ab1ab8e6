// SPDX-License-Identifier: MIT
//
// What a store already has of a sweep, of one build: a sweep that was stopped goes on from there.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/store/schema.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/sweep/cell_run.hpp"

namespace edgewise::sweep {

class StoredCells {
  public:
    /// rounds: how many the plan asks for.
    StoredCells(store::Store& store, std::string build, int rounds)
        : store_(store), build_(std::move(build)), rounds_(rounds) {}

    /// The status of a cell of which everything is there: figures, rounds, and caches as ordered now.
    [[nodiscard]] std::optional<std::string> status_of(const CellRun& cell) const {
        const auto row = store_.find_cell(build_, cell.row().hash);
        if (!row) return std::nullopt;
        if (row->is_timed() && (!rounds_missing(cell).empty() || (row->verified() && lacks_caches(cell))))
            return std::nullopt;
        return row->status;
    }

    /// Numbers of the rounds that the cell has not been timed in.
    [[nodiscard]] std::set<int> rounds_missing(const CellRun& cell) const {
        const auto done = store_.rounds_done(build_, cell.row().hash);
        std::set<int> missing;
        for (int round = 0; round < rounds_; ++round)
            if (!done.contains(round)) missing.insert(round);
        return missing;
    }

    [[nodiscard]] std::vector<measure::Round> rounds_of(const CellRun& cell) const {
        return store_.rounds(build_, cell.row().hash);
    }

    /// Seconds that a group took when it last ran, of this build or another.
    [[nodiscard]] std::optional<double> took(const std::string& group) const {
        const auto text = store_.meta(store::took_key + group);
        return text ? std::optional(std::stod(*text)) : std::nullopt;
    }
    void put_took(const std::string& group, double seconds) {
        store_.set_meta(store::took_key + group, fmt::format("{:.4g}", seconds));
    }

    void put(const CellRun& cell) { store_.put_cell(build_, cell.row(), cell.figures()); }
    void put(std::span<const std::pair<std::string, measure::Round>> round) {
        store_.put_round(build_, round);
    }

  private:
    /// An earlier run may not have modelled these machines, or fewer queries.
    [[nodiscard]] bool lacks_caches(const CellRun& cell) const {
        if (cell.caches().machines.empty()) return false;
        constexpr store::FigureName identity("caches.identity");
        const double wanted = cell.caches().identity();
        const std::vector<store::FigureRow> stored = store_.figures(build_, cell.row().hash);
        return std::none_of(stored.begin(), stored.end(), [&](const store::FigureRow& row) {
            return row.probe == identity.probe() && row.name == identity.name() && row.value == wanted;
        });
    }

    store::Store& store_;
    std::string build_;
    int rounds_;
};

}  // namespace edgewise::sweep
