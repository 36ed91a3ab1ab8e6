// SPDX-License-Identifier: MIT
//
// Columns of the schema and the structs made of them, once for all that read a store.
#pragma once

#include <optional>
#include <string>

#include "edgewise/measure/round.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/sqlite.hpp"

namespace edgewise::store {

/// In the order in which the functions below expect them, from column 0 on; further ones may follow.
template <class Row>
inline constexpr const char* columns_of = nullptr;
template <>
inline constexpr const char* columns_of<BuildRow> =
    "id, git_revision, compiler, flags, build_type, machine_json";
template <>
inline constexpr const char* columns_of<CellRow> =
    "hash, scene, scene_parameters, shape, shape_source, algorithm, layout, precision, table_type, vertices, "
    "edges, faces, seed, queries, status, reason, axes";
template <>
inline constexpr const char* columns_of<FigureRow> = "name, value, unit, reason, remedy, probe";
template <>
inline constexpr const char* columns_of<measure::Round> =
    "number, separated_queries, separated_ns, overlapping_queries, overlapping_ns, "
    "baseline_separated_queries, baseline_separated_ns, baseline_overlapping_queries, "
    "baseline_overlapping_ns";

[[nodiscard]] CellRow read_cell(const sqlite::Statement& row);
[[nodiscard]] FigureRow read_figure(const sqlite::Statement& row);
[[nodiscard]] measure::Round read_round(const sqlite::Statement& row);
[[nodiscard]] std::optional<BuildRow> find_build(const sqlite::Database& database, const std::string& id);

}  // namespace edgewise::store
