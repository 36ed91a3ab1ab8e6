// SPDX-License-Identifier: MIT
//
// Every select names its columns: the functions that read a row know them by number. All reads of a build are
// one transaction, so a sweep that writes meanwhile cannot mix two states.
#include "edgewise/store/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "edgewise/input/shown_text.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::store {

namespace {

/// In schema version 5 the name of a row's scene began with its run.
constexpr const char* run_by_old_name =
    "case when scene in ('stability', 'paging', 'thrash', 'thrash_realised') then scene "
    "when substr(scene, 1, 7) = 'effort ' then 'effort' when substr(scene, 1, 7) = 'fields ' then 'fields' "
    "else 'sweep' end";
constexpr const char* scene_by_old_name =
    "case when substr(scene, 1, 7) in ('effort ', 'fields ') then substr(scene, 8) else scene end";

/// Shows the table `cell` with today's columns, for this connection alone: nothing is written.
void show_runs_of_old_names(const sqlite::Database& database) {
    database.execute(
        fmt::format("pragma temp_store = memory; create temp view cell as select build, hash, {} "
                    "as scene, scene_parameters, shape, shape_source, algorithm, layout, "
                    "precision, table_type, vertices, edges, faces, seed, queries, status, "
                    "reason, axes, {} as run from main.cell",
                    scene_by_old_name, run_by_old_name)
            .c_str());
}

std::string select_cells() { return fmt::format("select {} from cell where build = ? ", cell_columns); }

/// Throws std::runtime_error if the text is not one of the names: another program wrote it.
template <class Enum, std::size_t count>
Enum named(const std::string& text, const std::string_view (&names)[count], const char* what) {
    const auto found = std::ranges::find(names, text);
    if (found == std::end(names))
        throw std::runtime_error(fmt::format("a cell of the store has {} '{}'; known: {}", what,
                                             input::shown_line(text), fmt::join(names, ", ")));
    return static_cast<Enum>(found - std::begin(names));
}

CellRow read_cell(const sqlite::Statement& s) {
    return {s.text(1),     s.text(2),     s.text(3),
            s.text(4),     s.text(5),     s.text(6),
            s.text(7),     s.text(8),     s.text(9),
            s.integer(10), s.integer(11), s.integer(12),
            s.natural(13), s.integer(14), named<CellStatus>(s.text(15), status_names, "the status"),
            s.text(16),    s.text(17),    s.text(18)};
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
    measure::Round round{static_cast<int>(s.integer(2)), read_timing(s, 3), read_timing(s, 7)};
    round.timing.either_queries = s.natural(11);
    round.timing.either_ns = s.real(12);
    round.timing.first_queries = s.natural(13);
    round.timing.first_ns = s.real(14);
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

std::string latest_build(const sqlite::Database& database) {
    sqlite::Statement named(
        database,
        "select b.id from meta m join build b on b.id = m.value where m.key = 'build' and exists "
        "(select 1 from cell c where c.build = b.id)");
    if (named.step()) return named.text(0);
    sqlite::Statement fullest(database,
                              "select build from cell group by build order by count(*) desc, build limit 1");
    if (fullest.step()) return fullest.text(0);
    throw std::runtime_error(
        fmt::format("the results store {} holds no cell: run a sweep first", database.path()));
}

/// Repairs a figure of a file that another program wrote: no value is infinite, and none is missing without a
/// reason.
void check(FigureRow& figure) {
    if (figure.value && !std::isfinite(*figure.value)) {
        figure.value.reset();
        figure.reason = "the stored value is not finite";
    }
    if (!figure.value && figure.reason.empty()) figure.reason = "the probe gave no reason";
}

}  // namespace

std::string insertion(const char* or_what, const char* table, std::string_view columns) {
    std::string places = "?";
    for (auto count = std::ranges::count(columns, ','); count > 0; --count) places += ",?";
    return fmt::format("insert {} into {}({}) values({})", or_what, table, columns, places);
}

void take_runs_from_old_names(const sqlite::Database& database) {
    database.execute(fmt::format("alter table cell add column run text not null default 'sweep'; update cell "
                                 "set scene = {}, run = {}; pragma user_version = {}",
                                 scene_by_old_name, run_by_old_name, store_schema_version)
                         .c_str());
}

void check_schema(const sqlite::Database& database) {
    if (database.number("pragma application_id") != store_application_id)
        throw std::runtime_error(
            fmt::format("{} is not a results store: name one that a sweep wrote", database.path()));
    const std::int64_t version = database.number("pragma user_version");
    if (version == store_schema_of_old_names)
        show_runs_of_old_names(database);
    else if (version != store_schema_version)
        throw std::runtime_error(
            fmt::format("{} has schema version {}, this program reads {}: write a new store with a sweep",
                        database.path(), version, store_schema_version));
}

std::string others_key_of(const std::string& build, const CellRow& cell) {
    return fmt::format("{}{} {} {} {}", others_key, build, cell.scene, cell.scene_parameters, cell.shape);
}

std::vector<std::pair<std::string, std::string>> meta_of(const sqlite::Database& database) {
    std::vector<std::pair<std::string, std::string>> meta;
    sqlite::Statement select(database, "select key, value from meta order by key");
    while (select.step()) meta.emplace_back(select.text(0), select.text(1));
    return meta;
}

std::optional<BuildRow> find_build(const sqlite::Database& database, const std::string& id) {
    sqlite::Statement select(database, fmt::format("select {} from build where id = ?", build_columns));
    return row_of(select.bind(id), read_build_row);
}

std::optional<CellRow> find_cell(const sqlite::Database& database, const std::string& build,
                                 const std::string& hash) {
    sqlite::Statement select(database, select_cells() + "and hash = ?");
    return row_of(select.bind(build, hash), read_cell);
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
        fmt::format("select {} from round where build = ? and hash = ? order by number", round_columns));
    return rows_of(select.bind(build, hash), read_round);
}

measure::Figure StoredCell::figure(const std::string& probe, const std::string& name) const {
    for (const FigureRow& stored : figures)
        if (stored.probe == probe && stored.name == name) return stored;
    const std::string why = verified() ? "no such figure is stored"
                                       : fmt::format("the cell is {}: {}", to_string(status), reason);
    return {name, std::nullopt, "", why};
}

StoredBuild read_build(const std::string& store, const std::string& id, const OnCell& on_cell) {
    const sqlite::Database database = sqlite::Database::for_reading(store);
    database.execute("begin");
    check_schema(database);
    StoredBuild read;
    read.meta = meta_of(database);
    const std::string wanted = id.empty() ? latest_build(database) : id;
    const auto build = find_build(database, wanted);
    if (!build) throw std::runtime_error(fmt::format("the results store {} has no build {}", store, wanted));
    read.build = *build;
    sqlite::Statement others(database, "select id from build where id <> ? order by id");
    others.bind(wanted);
    while (others.step()) read.other_builds.push_back(others.text(0));
    sqlite::Statement select(database, select_cells() + "order by hash");
    std::vector<CellRow> rows = rows_of(select.bind(wanted), read_cell);
    for (CellRow& row : rows) {
        StoredCell& cell = read.cells.emplace_back(StoredCell{std::move(row)});
        cell.figures = figures_of(database, wanted, cell.hash);
        for (FigureRow& figure : cell.figures) check(figure);
        cell.rounds = rounds_of(database, wanted, cell.hash);
        if (on_cell) on_cell(read.cells.size(), rows.size());
    }
    return read;
}

}  // namespace edgewise::store
