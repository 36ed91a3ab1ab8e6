// SPDX-License-Identifier: MIT
//
// Every select names its columns: the functions that read a row know them by number.
#include "edgewise/store/read_rows.hpp"

#include <fmt/core.h>

#include <stdexcept>

#include "edgewise/store/schema.hpp"

namespace edgewise::store {

namespace {

const std::string select_cells =
    "select hash, scene, scene_parameters, shape, shape_source, algorithm, layout, precision, table_type, "
    "vertices, edges, faces, seed, queries, status, reason, axes from cell where build = ? ";

CellRow read_cell(const sqlite::Statement& s) {
    return {s.text(0),     s.text(1),     s.text(2),  s.text(3),    s.text(4),     s.text(5),
            s.text(6),     s.text(7),     s.text(8),  s.integer(9), s.integer(10), s.integer(11),
            s.natural(12), s.integer(13), s.text(14), s.text(15),   s.text(16)};
}

BuildRow read_build_row(const sqlite::Statement& s) {
    return {s.text(0), s.text(1), s.text(2), s.text(3), s.text(4), s.text(5)};
}

FigureRow read_figure(const sqlite::Statement& s) {
    return {{s.text(0), s.optional_real(1), s.text(2), s.text(3), s.text(4)}, s.text(5)};
}

measure::Timing read_timing(const sqlite::Statement& s, int column) {
    return {s.natural(column), s.natural(column + 2), s.real(column + 1), s.real(column + 3)};
}

measure::Round read_round(const sqlite::Statement& s) {
    measure::Round round{static_cast<int>(s.integer(0)), read_timing(s, 1), read_timing(s, 5)};
    round.timing.either_queries = s.natural(9);
    round.timing.either_ns = s.real(10);
    round.timing.first_queries = s.natural(11);
    round.timing.first_ns = s.real(12);
    return round;
}

template <class Row>
std::vector<Row> rows_of(sqlite::Statement& bound, Row (*read)(const sqlite::Statement& row)) {
    std::vector<Row> rows;
    while (bound.step()) rows.push_back(read(bound));
    return rows;
}

template <class Row>
std::optional<Row> row_of(sqlite::Statement& bound, Row (*read)(const sqlite::Statement& row)) {
    if (!bound.step()) return std::nullopt;
    return read(bound);
}

}  // namespace

void check_schema(const sqlite::Database& database) {
    if (database.number("pragma application_id") != store_application_id)
        throw std::runtime_error(
            fmt::format("{} is not a results store: name one that a sweep wrote", database.path()));
    const std::int64_t version = database.number("pragma user_version");
    if (version != store_schema_version)
        throw std::runtime_error(
            fmt::format("{} has schema version {}, this program reads {}: write a new store with a sweep",
                        database.path(), version, store_schema_version));
}

std::vector<std::pair<std::string, std::string>> meta_of(const sqlite::Database& database) {
    std::vector<std::pair<std::string, std::string>> meta;
    sqlite::Statement select(database, "select key, value from meta order by key");
    while (select.step()) meta.emplace_back(select.text(0), select.text(1));
    return meta;
}

std::optional<BuildRow> find_build(const sqlite::Database& database, const std::string& id) {
    sqlite::Statement select(
        database,
        "select id, git_revision, compiler, flags, build_type, machine_json from build where id = ?");
    return row_of(select.bind(id), read_build_row);
}

std::optional<CellRow> find_cell(const sqlite::Database& database, const std::string& build,
                                 const std::string& hash) {
    sqlite::Statement select(database, select_cells + "and hash = ?");
    return row_of(select.bind(build, hash), read_cell);
}

std::vector<CellRow> cells_of(const sqlite::Database& database, const std::string& build) {
    sqlite::Statement select(database, select_cells + "order by hash");
    return rows_of(select.bind(build), read_cell);
}

std::vector<FigureRow> figures_of(const sqlite::Database& database, const std::string& build,
                                  const std::string& hash) {
    sqlite::Statement select(database,
                             "select name, value, unit, reason, remedy, probe from figure "
                             "where build = ? and hash = ? order by probe, name");
    return rows_of(select.bind(build, hash), read_figure);
}

std::vector<measure::Round> rounds_of(const sqlite::Database& database, const std::string& build,
                                      const std::string& hash) {
    sqlite::Statement select(
        database,
        "select number, separated_queries, separated_ns, overlapping_queries, overlapping_ns, "
        "baseline_separated_queries, baseline_separated_ns, baseline_overlapping_queries, "
        "baseline_overlapping_ns, either_queries, either_ns, first_queries, first_ns "
        "from round where build = ? and hash = ? order by number");
    return rows_of(select.bind(build, hash), read_round);
}

}  // namespace edgewise::store
