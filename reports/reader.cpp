// SPDX-License-Identifier: MIT
//
// See reader.hpp. All reads are one transaction, so a sweep that writes meanwhile cannot mix two states.
#include "edgewise/reports/reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <tuple>

#include "edgewise/reports/store_query.hpp"
#include "edgewise/reports/tables/scene_label.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

using CellIndex = std::map<std::string, std::size_t>;

std::int64_t pragma(const ReadOnlyDatabase& database, const std::string& name) {
    StoreQuery query(database, "pragma " + name);
    return query.next() ? query.integer(0) : 0;
}

void check_schema(const ReadOnlyDatabase& database) {
    if (pragma(database, "application_id") != store::store_application_id)
        throw std::runtime_error(
            fmt::format("{} is not a results store: name one that a sweep wrote", database.path()));
    const std::int64_t version = pragma(database, "user_version");
    if (version != store::store_schema_version)
        throw std::runtime_error(
            fmt::format("{} has schema version {}, this program reads {}: write a new store with a sweep",
                        database.path(), version, store::store_schema_version));
}

std::string latest_build(const ReadOnlyDatabase& database) {
    StoreQuery named(
        database,
        "select b.id from meta m join build b on b.id = m.value where m.key = 'build' and exists "
        "(select 1 from cell c where c.build = b.id)");
    if (named.next()) return named.text(0);
    StoreQuery fullest(database,
                       "select build from cell group by build order by count(*) desc, build limit 1");
    if (fullest.next()) return fullest.text(0);
    throw std::runtime_error(
        fmt::format("the results store {} holds no cell: run a sweep first", database.path()));
}

ReportBuild read_build(const ReadOnlyDatabase& database, const std::string& id) {
    StoreQuery query(
        database,
        "select id, git_revision, compiler, flags, build_type, machine_json from build where id = ?");
    query.bind(1, id);
    if (!query.next())
        throw std::runtime_error(fmt::format("the results store {} has no build {}", database.path(), id));
    return {query.text(0), query.text(1), query.text(2), query.text(3), query.text(4), query.text(5)};
}

ReportCell read_cell(const StoreQuery& row) {
    ReportCell cell;
    cell.hash = row.text(0);
    cell.scene = row.text(1);
    cell.scene_parameters = row.text(2);
    cell.shape = row.text(3);
    cell.shape_source = row.text(4);
    cell.algorithm = row.text(5);
    cell.layout = row.text(6);
    cell.precision = row.text(7);
    cell.table = row.text(8);
    cell.vertices = row.integer(9);
    cell.edges = row.integer(10);
    cell.faces = row.integer(11);
    // Stored as the signed number of the same bits.
    cell.seed = static_cast<std::uint64_t>(row.integer(12));
    cell.queries = row.integer(13);
    cell.status = row.text(14);
    cell.reason = row.text(15);
    cell.axes = row.text(16);
    if (!cell.axes.empty()) cell.table += " " + cell.axes;
    return cell;
}

std::vector<ReportCell> read_cells(const ReadOnlyDatabase& database, const std::string& build) {
    StoreQuery query(
        database,
        "select hash, scene, scene_parameters, shape, shape_source, algorithm, layout, precision, "
        "table_type, vertices, edges, faces, seed, queries, status, reason, axes from cell where build = ?");
    query.bind(1, build);
    std::vector<ReportCell> cells;
    while (query.next()) cells.push_back(read_cell(query));
    std::sort(cells.begin(), cells.end(), [](const ReportCell& a, const ReportCell& b) {
        return std::tie(a.scene, a.scene_parameters, a.vertices, a.shape, a.algorithm, a.table, a.hash) <
               std::tie(b.scene, b.scene_parameters, b.vertices, b.shape, b.algorithm, b.table, b.hash);
    });
    return cells;
}

void read_figures(const ReadOnlyDatabase& database, const std::string& build, const CellIndex& index,
                  std::vector<ReportCell>& cells) {
    StoreQuery query(database,
                     "select hash, probe, name, value, unit, reason, remedy from figure where build = ? "
                     "order by hash, probe, name");
    query.bind(1, build);
    while (query.next()) {
        const auto at = index.find(query.text(0));
        if (at == index.end()) continue;
        StoredFigure figure{query.text(1), query.text(2), query.real(3),
                            query.text(4), query.text(5), query.text(6)};
        if (figure.value && !std::isfinite(*figure.value)) {
            figure.value.reset();
            figure.reason = "the stored value is not finite";
        }
        if (!figure.value && figure.reason.empty()) figure.reason = "the probe gave no reason";
        cells[at->second].figures.push_back(std::move(figure));
    }
}

/// Of the pairs whose four columns begin at each of `firsts`, together.
std::optional<double> ratio(const StoreQuery& row, std::initializer_list<int> firsts) {
    double queries = 0, ns = 0, base_queries = 0, base_ns = 0;
    for (const int first : firsts) {
        queries += row.real(first).value_or(0);
        ns += row.real(first + 1).value_or(0);
        base_queries += row.real(first + 2).value_or(0);
        base_ns += row.real(first + 3).value_or(0);
    }
    if (queries <= 0 || base_queries <= 0 || ns <= 0 || base_ns <= 0) return std::nullopt;
    return (ns / queries) / (base_ns / base_queries);
}

void read_rounds(const ReadOnlyDatabase& database, const std::string& build, const CellIndex& index,
                 std::vector<ReportCell>& cells) {
    StoreQuery query(
        database,
        "select hash, separated_queries, separated_ns, baseline_separated_queries, "
        "baseline_separated_ns, overlapping_queries, overlapping_ns, baseline_overlapping_queries, "
        "baseline_overlapping_ns from round where build = ? order by hash, number");
    query.bind(1, build);
    while (query.next()) {
        const auto at = index.find(query.text(0));
        if (at == index.end()) continue;
        cells[at->second].rounds.push_back({ratio(query, {1}), ratio(query, {5}), ratio(query, {1, 5})});
    }
}

/// Moves the cells of which `is_one` is true.
template <class IsOne>
std::vector<ReportCell> take_out(std::vector<ReportCell>& cells, IsOne is_one) {
    std::vector<ReportCell> taken;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(taken), is_one);
    std::erase_if(cells, is_one);
    label_scenes(taken);
    return taken;
}

/// Scenes by name, the rows of other runs, and the cells of scenes from files.
void sort_out(ReportData& data) {
    const std::string prefix = store::scene_file_key;
    std::set<std::string> names;
    for (const auto& [key, value] : data.meta) {
        if (key.rfind(prefix, 0) != 0) continue;
        data.scene_files.emplace_back(key.substr(prefix.size()), value);
        names.insert(data.scene_files.back().first);
    }
    const auto of_scene = [](const char* name) {
        return [name](const ReportCell& cell) { return cell.scene == name; };
    };
    data.stability = take_out(data.cells, of_scene("stability"));
    data.paging = take_out(data.cells, of_scene("paging"));
    data.from_files =
        take_out(data.cells, [&](const ReportCell& cell) { return names.contains(cell.scene); });
    label_scenes(data.cells);
}

}  // namespace

StoredFigure ReportCell::figure(const std::string& probe, const std::string& name) const {
    for (const StoredFigure& stored : figures)
        if (stored.probe == probe && stored.name == name) return stored;
    const std::string why =
        verified() ? "no such figure is stored" : fmt::format("the cell is {}: {}", status, reason);
    return {probe, name, std::nullopt, "", why, ""};
}

std::size_t ReportData::count(const std::string& status) const {
    const auto has_it = [&](const ReportCell& cell) { return cell.status == status; };
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), has_it) +
                                    std::count_if(from_files.begin(), from_files.end(), has_it));
}

bool ReportData::any_failed() const {
    const auto failed = [](const ReportCell& row) { return row.status == "failed"; };
    return count("failed") > 0 || std::any_of(stability.begin(), stability.end(), failed);
}

ReportData read_report(const std::string& store, const std::string& build) {
    const ReadOnlyDatabase database(store);
    StoreQuery begin(database, "begin");
    (void)begin.next();
    check_schema(database);
    ReportData data;
    StoreQuery meta(database, "select key, value from meta order by key");
    while (meta.next()) data.meta.emplace_back(meta.text(0), meta.text(1));
    data.build = read_build(database, build.empty() ? latest_build(database) : build);
    StoreQuery others(database, "select id from build where id <> ? order by id");
    others.bind(1, data.build.id);
    while (others.next()) data.other_builds.push_back(others.text(0));
    data.cells = read_cells(database, data.build.id);
    CellIndex index;
    for (std::size_t i = 0; i < data.cells.size(); ++i) index[data.cells[i].hash] = i;
    read_figures(database, data.build.id, index, data.cells);
    read_rounds(database, data.build.id, index, data.cells);
    sort_out(data);
    return data;
}

}  // namespace edgewise::reports
