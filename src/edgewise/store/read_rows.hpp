// SPDX-License-Identifier: MIT
//
// The rows of a store, once for all that read one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "edgewise/measure/round.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/sqlite.hpp"

namespace edgewise::store {

/// Columns in the order in which rows are written and copied; a table may have further ones.
inline constexpr const char *build_columns = "id, git_revision, compiler, flags, build_type, machine_json",
                            *cell_columns =
                                "build, hash, scene, scene_parameters, shape, shape_source, "
                                "algorithm, layout, precision, table_type, vertices, edges, "
                                "faces, seed, queries, status, reason, axes, run",
                            *figure_columns = "build, hash, probe, name, value, unit, reason, remedy",
                            *round_columns =
                                "build, hash, number, separated_queries, separated_ns, overlapping_queries, "
                                "overlapping_ns, baseline_separated_queries, baseline_separated_ns, "
                                "baseline_overlapping_queries, baseline_overlapping_ns, either_queries, "
                                "either_ns, first_queries, first_ns";
/// "insert or ignore into build(id, ...) values(?,...)", a ? for each column.
[[nodiscard]] std::string insertion(const char* or_what, const char* table, std::string_view columns);

/// Throws std::runtime_error: what, where, what to do, unless it is a store that this program reads. One of
/// schema version 5 is read as if it had today's columns.
void check_schema(const sqlite::Database& database);
/// Makes a store of schema version 5 one of today's; inside a transaction of the caller.
void take_runs_from_old_names(const sqlite::Database& database);

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
