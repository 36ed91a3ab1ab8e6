// SPDX-License-Identifier: MIT
//
// The store over SQLite. Why it survives:
//   - journal_mode WAL: a transaction is one append to the log, and its commit record makes it whole; a log
//     cut short by a kill is read up to the last whole commit. Readers never wait for the sweep.
//   - synchronous FULL: a commit returns when the log is on the disk. NORMAL would survive kill -9 too, but
//     may lose the last commits at a power cut; a round takes seconds and the sync milliseconds, outside any
//     timing.
//   - Where a file system cannot do WAL (no shared memory), SQLite stays with its rollback journal: as safe,
//     and readers wait.
// The file is checked before the first write: no pragma that writes runs on a file that is not ours.
#include "edgewise/store/store.hpp"

#include <fmt/core.h>
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "edgewise/store/rows.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::store {

namespace {

[[noreturn]] void refuse(const sqlite::Database& database, const std::string& why) {
    throw std::runtime_error(fmt::format("store {}: {}; it was not touched", database.path(), why));
}

/// True for an empty file that is to become a store, false for a store of ours, otherwise throws.
bool is_new(const sqlite::Database& database) {
    const std::int64_t version = database.number("pragma user_version");
    const std::int64_t owner = database.number("pragma application_id");
    const std::int64_t objects = database.number("select count(*) from sqlite_schema");
    if (version == 0 && owner == 0 && objects == 0) return true;
    if (owner != store_application_id)
        refuse(database, "an SQLite file, but not an Edgewise store: name another store");
    if (version == store_schema_version || version == store_schema_of_old_names) return false;
    refuse(database, fmt::format("schema version {}, {} {}: {}name another store", version,
                                 version > store_schema_version ? "but this program knows only up to"
                                                                : "too old for this program, which writes",
                                 store_schema_version,
                                 version > store_schema_version ? "use a newer program or " : ""));
}

/// Another program may have been first between our look and our lock.
void take_old_names(const sqlite::Database& database) {
    if (database.number("pragma user_version") != store_schema_of_old_names) return;
    sqlite::Transaction transaction(database);
    if (database.number("pragma user_version") == store_schema_of_old_names)
        take_runs_from_old_names(database);
    transaction.commit();
}

void create_schema(const sqlite::Database& database) {
    sqlite::Transaction transaction(database);
    // Another program may have been first between our look and our lock.
    if (is_new(database)) {
        database.execute(store_schema);
        database.execute(fmt::format("pragma application_id = {}; pragma user_version = {}",
                                     store_application_id, store_schema_version)
                             .c_str());
    }
    transaction.commit();
}

/// Text and JSON know no infinity, and SQLite turns NaN into a bare null: both become null with a reason.
FigureRow storable(FigureRow figure) {
    if (figure.value && !std::isfinite(*figure.value)) {
        figure.reason = fmt::format("not a finite number ({})", *figure.value);
        figure.value.reset();
    }
    return figure;
}

void put_figures(const sqlite::Database& database, const std::string& build, const std::string& hash,
                 std::span<const FigureRow> figures) {
    sqlite::Statement(database, "delete from figure where build = ? and hash = ?").bind(build, hash).run();
    sqlite::Statement insert(database, insertion("", "figure", figure_columns));
    for (const FigureRow& row : figures) {
        const FigureRow f = storable(row);
        if (!f.value && f.reason.empty()) {
            throw std::runtime_error(
                fmt::format("cell {}: figure {}/{} has neither a value nor a reason; its probe must give one",
                            hash, f.probe, f.name));
        }
        insert.bind(build, hash, f.probe, f.name, f.value, f.unit, f.reason, f.remedy).run();
    }
}

}  // namespace

Store::Store(const std::string& path) : database_(path) {
    const bool fresh = is_new(database_);
    // A write-protected file opens, and would only fail at the first round.
    if (sqlite3_db_readonly(database_.handle(), "main") == 1)
        refuse(database_, "write-protected: make it writable or name another store");
    database_.execute("pragma journal_mode = wal; pragma synchronous = full; pragma foreign_keys = on");
    if (fresh) create_schema(database_);
    take_old_names(database_);
}

void Store::put_build(const BuildRow& b) {
    sqlite::Statement(database_, insertion("", "build", build_columns) +
                                     " on conflict(id) do update set "
                                     "git_revision = excluded.git_revision, compiler = excluded.compiler, "
                                     "flags = excluded.flags, build_type = excluded.build_type, "
                                     "machine_json = excluded.machine_json")
        .bind(b.id, b.git_revision, b.compiler, b.flags, b.build_type, b.machine_json)
        .run();
}

void Store::put_cell(const std::string& build, const CellRow& c, std::span<const FigureRow> figures) {
    sqlite::Transaction transaction(database_);
    sqlite::Statement(database_, insertion("or replace", "cell", cell_columns))
        .bind(build, c.hash, c.scene, c.scene_parameters, c.shape, c.shape_source, c.algorithm, c.layout,
              c.precision, c.table, c.vertices, c.edges, c.faces, c.seed, c.queries, to_string(c.status),
              c.reason, c.axes, c.run)
        .run();
    put_figures(database_, build, c.hash, figures);
    transaction.commit();
}

void Store::put_round(const std::string& build,
                      std::span<const std::pair<std::string, measure::Round>> rounds) {
    sqlite::Transaction transaction(database_);
    sqlite::Statement insert(database_, insertion("or replace", "round", round_columns));
    for (const auto& [hash, round] : rounds) {
        const measure::Timing& t = round.timing;
        const measure::Timing& b = round.baseline;
        insert
            .bind(build, hash, round.number, t.separated_queries, t.separated_ns, t.overlapping_queries,
                  t.overlapping_ns, b.separated_queries, b.separated_ns, b.overlapping_queries,
                  b.overlapping_ns, t.either_queries, t.either_ns, t.first_queries, t.first_ns)
            .run();
    }
    transaction.commit();
}

std::optional<StoredCell> Store::find_cell(const std::string& build, const std::string& hash) const {
    auto row = store::find_cell(database_, build, hash);
    if (!row) return std::nullopt;
    return StoredCell{*std::move(row), figures_of(database_, build, hash)};
}

std::vector<FigureRow> Store::with_stored_figures(const std::string& build, const std::string& hash,
                                                  std::vector<FigureRow> figures) const {
    // Errors are of one population: those of other answers do not complete them.
    const bool has_errors = std::ranges::find(figures, "error", &FigureRow::probe) != figures.end();
    for (const FigureRow& old : figures_of(database_, build, hash)) {
        if (has_errors && old.probe == "error") continue;
        const auto now = std::ranges::find_if(figures, [&](const FigureRow& figure) {
            return figure.probe == old.probe && figure.name == old.name;
        });
        if (!old.value) continue;
        if (now == figures.end())
            figures.push_back(old);
        else if (!now->value)
            *now = old;
    }
    return figures;
}

std::vector<measure::Round> Store::rounds(const std::string& build, const std::string& hash) const {
    return rounds_of(database_, build, hash);
}

std::set<int> Store::rounds_done(const std::string& build, const std::string& hash) const {
    sqlite::Statement s(database_, "select number from round where build = ? and hash = ?");
    s.bind(build, hash);
    std::set<int> numbers;
    while (s.step()) numbers.insert(static_cast<int>(s.integer(0)));
    return numbers;
}

void Store::set_shard(const std::string& shard, bool is_complete) {
    set_meta(shard_key, shard);
    set_meta(complete_key, is_complete ? shard : "");
}

void Store::set_meta(const std::string& key, const std::string& value) {
    sqlite::Statement(database_, "insert or replace into meta values(?,?)").bind(key, value).run();
}

std::optional<std::string> Store::meta(const std::string& key) const {
    sqlite::Statement s(database_, "select value from meta where key = ?");
    s.bind(key);
    if (!s.step()) return std::nullopt;
    return s.text(0);
}

}  // namespace edgewise::store
