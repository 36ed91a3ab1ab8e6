// SPDX-License-Identifier: MIT
//
// See reader.hpp. All reads are one transaction, so a sweep that writes meanwhile cannot mix two states.
#include "edgewise/store/reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "edgewise/store/read_rows.hpp"
#include "edgewise/store/sqlite.hpp"

namespace edgewise::store {

namespace {

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

/// Files that another program wrote may hold what a store never does.
void check(FigureRow& figure) {
    if (figure.value && !std::isfinite(*figure.value)) {
        figure.value.reset();
        figure.reason = "the stored value is not finite";
    }
    if (!figure.value && figure.reason.empty()) figure.reason = "the probe gave no reason";
}

}  // namespace

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
    std::vector<CellRow> rows = cells_of(database, wanted);
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
