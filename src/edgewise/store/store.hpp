// SPDX-License-Identifier: MIT
//
// One SQLite file with everything that a sweep measured. Rows have the keys cell and build, so figures of a
// rebuilt program are never mixed with older ones. Every round is one transaction, so a killed sweep loses at
// most the current round. Written data is on the disk when a call returns. One thread at a time; several
// programs may share a store and wait for each other.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/round.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/sqlite.hpp"

namespace edgewise::store {

class Store {
  public:
    /// Opens or creates the file. Throws std::runtime_error that names the file if that fails or if the
    /// schema is foreign or newer; a foreign file is not changed. Every other call throws the same when it
    /// fails.
    explicit Store(const std::string& path);

    /// Adds a build; call it before its cells are added. Replaces an earlier row of the same id.
    void put_build(const BuildRow& build);
    /// Adds a cell and its figures in one transaction. Replaces an earlier row of the same cell and build
    /// with all its figures, and keeps its rounds. A value that is not finite is stored as null, with that as
    /// the reason. Throws for a null figure without a reason.
    void put_cell(const std::string& build, const CellRow& cell, std::span<const FigureRow> figures);
    /// Adds one round of several cells (by hash) in one transaction; replaces rounds of the same number.
    void put_round(const std::string& build, std::span<const std::pair<std::string, measure::Round>> rounds);

    /// A cell with its figures and without its rounds.
    [[nodiscard]] std::optional<StoredCell> find_cell(const std::string& build,
                                                      const std::string& hash) const;
    /// The figures, with those values that only the store has of this cell.
    [[nodiscard]] std::vector<FigureRow> with_stored_figures(const std::string& build,
                                                             const std::string& hash,
                                                             std::vector<FigureRow> figures) const;
    [[nodiscard]] std::set<int> rounds_done(const std::string& build, const std::string& hash) const;
    /// Rounds of a cell, by number.
    [[nodiscard]] std::vector<measure::Round> rounds(const std::string& build, const std::string& hash) const;

    /// Sets a value of the table `meta`: plan name, start time, command line ...
    void set_meta(const std::string& key, const std::string& value);
    /// Notes which shard of its rows the store has, and if all of it was measured.
    void set_shard(const std::string& shard, bool is_complete);
    /// Value of a key; nothing if it was never set.
    [[nodiscard]] std::optional<std::string> meta(const std::string& key) const;

  private:
    sqlite::Database database_;
};

}  // namespace edgewise::store
