// SPDX-License-Identifier: MIT
//
// Reads all that a store holds of one build. The file is opened for reading alone; a sweep may be writing it.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/round.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/vocabulary.hpp"

namespace edgewise::store {

struct StoredCell : CellRow {
    std::vector<FigureRow> figures = {};      ///< in order of probe and name
    std::vector<measure::Round> rounds = {};  ///< in order of number

    /// The stored figure; where none is stored, one without a value whose reason says so.
    [[nodiscard]] measure::Figure figure(const std::string& probe, const std::string& name) const;
    [[nodiscard]] measure::Figure figure(const FigureName& name) const {
        return figure(name.probe(), name.name());
    }
};

struct StoredBuild {
    std::vector<std::pair<std::string, std::string>> meta;  ///< in order of key
    BuildRow build;
    std::vector<std::string> other_builds;  ///< ids of the other builds in the store
    std::vector<StoredCell> cells;          ///< by hash
};

/// Cells read, and how many there are.
using OnCell = std::function<void(std::size_t done, std::size_t all)>;

/// Reads one build; an empty `build` means the latest: the one that the key `build` of `meta` names, else the
/// one with the most cells (ties: the smallest id). `on_cell` is called after every cell. Throws
/// std::runtime_error with one line: what, where, what to do.
[[nodiscard]] StoredBuild read_build(const std::string& store, const std::string& build = {},
                                     const OnCell& on_cell = {});

}  // namespace edgewise::store
