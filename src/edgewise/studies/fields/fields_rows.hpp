// SPDX-License-Identifier: MIT
//
// The fields run: advice on the records of some table types (fields.hpp), as rows of the store of
// store::Run::fields.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "edgewise/store/rows.hpp"
#include "edgewise/store/store.hpp"
#include "edgewise/studies/fields/fields.hpp"

namespace edgewise::studies {

/// Returns the cells that a plan asks about: the paper's record by both algorithms, if this program can
/// build it in other groups.
[[nodiscard]] std::vector<CellChoice> fields_cells(std::size_t queries, std::uint64_t seed);

[[nodiscard]] store::CellRow fields_row(const CellChoice& choice);
[[nodiscard]] std::vector<store::FigureRow> fields_figures(const FieldsAdvice& advice);

/// Writes the rows that are not yet in the store, and calls on_row for each. Returns false if it was stopped
/// before the last row.
[[nodiscard]] bool store_fields(const std::vector<CellChoice>& cells, const std::string& build,
                                store::Store& store, const std::function<void(const store::CellRow&)>& on_row,
                                const std::atomic<bool>& stop);

}  // namespace edgewise::studies
