// SPDX-License-Identifier: MIT
//
// The rows of a store, once for all that read one.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/measure/round.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/sqlite.hpp"

namespace edgewise::store {

/// Throws std::runtime_error: what, where, what to do, unless it is a store of this program's version.
void check_schema(const sqlite::Database& database);

/// By key.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> meta_of(const sqlite::Database& database);

[[nodiscard]] std::optional<BuildRow> find_build(const sqlite::Database& database, const std::string& id);
[[nodiscard]] std::optional<CellRow> find_cell(const sqlite::Database& database, const std::string& build,
                                               const std::string& hash);
/// By hash.
[[nodiscard]] std::vector<CellRow> cells_of(const sqlite::Database& database, const std::string& build);
/// Of one cell, by probe, then by name.
[[nodiscard]] std::vector<FigureRow> figures_of(const sqlite::Database& database, const std::string& build,
                                                const std::string& hash);
/// Of one cell, by number.
[[nodiscard]] std::vector<measure::Round> rounds_of(const sqlite::Database& database,
                                                    const std::string& build, const std::string& hash);

}  // namespace edgewise::store
