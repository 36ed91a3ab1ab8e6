// SPDX-License-Identifier: MIT
//
// One SQLite file that holds everything a sweep measured. Rows are keyed by cell and build, so a rebuilt
// program never mixes its figures with those of the old one; every round is one transaction, so a kill loses
// at most the round in hand. What a call wrote is on the disk when it returns. One thread at a time; several
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
    /// Opens or creates; throws std::runtime_error naming the file when it cannot or when the schema is
    /// foreign or newer. A file that is not ours is left as it was. Every other call throws likewise when it
    /// fails.
    explicit Store(const std::string& path);

    /// Before the cells of that build; replaces an earlier row of the same id.
    void put_build(const BuildRow& build);
    /// Cell and its figures, in one transaction; replaces an earlier row of the same cell and build, with all
    /// its figures; its rounds stay. A value that is not finite is stored as null with that as the reason; a
    /// null figure without a reason is refused.
    void put_cell(const std::string& build, const CellRow& cell, std::span<const FigureRow> figures);
    /// One round of several cells (by their hash), in one transaction; replaces rounds of the same number.
    void put_round(const std::string& build, std::span<const std::pair<std::string, measure::Round>> rounds);

    [[nodiscard]] std::optional<CellRow> find_cell(const std::string& build, const std::string& hash) const;
    /// By probe, then by name.
    [[nodiscard]] std::vector<FigureRow> figures(const std::string& build, const std::string& hash) const;
    [[nodiscard]] std::set<int> rounds_done(const std::string& build, const std::string& hash) const;
    /// By number.
    [[nodiscard]] std::vector<measure::Round> rounds(const std::string& build, const std::string& hash) const;

    /// Plan name, start time, command line ...
    void set_meta(const std::string& key, const std::string& value);
    /// Nothing where the key was never set.
    [[nodiscard]] std::optional<std::string> meta(const std::string& key) const;

  private:
    sqlite::Database database_;
};

}  // namespace edgewise::store
