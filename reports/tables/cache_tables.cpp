// SPDX-License-Identifier: MIT
//
// Which machines and levels there are is read off the figures' names:
// MACHINE.LEVEL.WHAT, or MACHINE/POLICY.LEVEL.WHAT. Whether a ranking of tables by modelled misses depends on
// the replacement policy or on prefetching: true LRU without prefetching is an approximation of what
// processors do; tree-PLRU, random replacement and two prefetchers bound what it may hide.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "edgewise/input/json_text.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

/// The levels of a machine, as the figures of any cell name them: caches from the first on, then TLBs.
std::vector<std::string> levels_of(const ReportData& data, const std::string& machine) {
    std::set<std::pair<bool, std::string>> found;
    for (const ReportCell* cell : data.swept()) {
        for (const store::FigureRow& figure : cell->figures) {
            if (const auto level = store::level_misses.all.of(machine).value_in(figure.probe, figure.name))
                found.insert({level->find("TLB") != std::string::npos, *level});
        }
    }
    std::vector<std::string> levels;
    for (const auto& [is_tlb, level] : found) levels.push_back(level);
    return levels;
}

/// Returns a row for each cell with modelled caches.
template <class FigureColumns>
TextGrid cache_grid(const ReportData& data, const std::string& caption, const FigureColumns& columns) {
    return cell_grid(caption, cell_names, columns, modelled_cells(data));
}

/// Misses that differ by less than this part are not ranked.
constexpr double tie = 0.01;

struct Ranked {
    std::string table;
    double lru, other;
};

bool disagree(const Ranked& a, const Ranked& b) {
    const auto before = [](double x, double y) { return x < (1 - tie) * y; };
    return (before(a.lru, b.lru) && before(b.other, a.other)) ||
           (before(b.lru, a.lru) && before(a.other, b.other));
}

using PolicyGroup = std::tuple<std::string, std::string, std::string, std::string, std::string>;

std::vector<GridCell> policy_row(const PolicyGroup& group, const std::vector<Ranked>& tables) {
    std::size_t pairs = 0, changed = 0;
    std::string example = "–";
    for (std::size_t i = 0; i < tables.size(); ++i) {
        for (std::size_t j = i + 1; j < tables.size(); ++j) {
            ++pairs;
            if (!disagree(tables[i], tables[j])) continue;
            if (changed++ == 0)
                example =
                    fmt::format("{} ({:.3g}, {:.3g}) and {} ({:.3g}, {:.3g})", tables[i].table, tables[i].lru,
                                tables[i].other, tables[j].table, tables[j].lru, tables[j].other);
        }
    }
    const auto& [scene, shape, algorithm, policy, level] = group;
    return grid_row(scene, shape, algorithm, policy, level, pairs, changed, changed == 0 ? "no" : "yes",
                    example);
}

/// A level of a machine under another policy: "zen5/random" and "L1D".
using PolicyLevel = std::pair<std::string, std::string>;

std::vector<PolicyLevel> policy_levels(const ReportCell& cell) {
    std::vector<PolicyLevel> found;
    for (const store::FigureRow& figure : cell.figures) {
        const std::size_t slash = figure.name.find('/'), dot = figure.name.find('.', slash);
        if (figure.probe != "caches" || slash == std::string::npos || dot == std::string::npos) continue;
        const std::size_t end = figure.name.find('.', dot + 1);
        if (end == std::string::npos) continue;
        const PolicyLevel at{figure.name.substr(0, dot), figure.name.substr(dot + 1, end - dot - 1)};
        if (figure.name == store::level_misses.all.of(at.first, at.second).name()) found.push_back(at);
    }
    return found;
}

}  // namespace

std::vector<const ReportCell*> modelled_cells(const ReportData& data) {
    std::vector<const ReportCell*> cells = verified_cells(data);
    std::erase_if(cells, [](const ReportCell* cell) { return !cell->figure("reuse.line_knee_bytes").value; });
    std::ranges::stable_sort(cells, [](const ReportCell* a, const ReportCell* b) {
        const double lines_a = or_infinity(*a, "reuse.lines_per_query"),
                     lines_b = or_infinity(*b, "reuse.lines_per_query");
        return std::tie(a->scene_label, a->vertices, b->algorithm, lines_a) <
               std::tie(b->scene_label, b->vertices, a->algorithm, lines_b);
    });
    return cells;
}

std::vector<std::string> modelled_machines(const ReportData& data) {
    std::set<std::string> found;
    for (const ReportCell* cell : data.swept()) {
        for (const store::FigureRow& figure : cell->figures) {
            const std::size_t dot = figure.name.find('.');
            if (figure.probe != "caches" || dot == std::string::npos) continue;
            if (const std::string name = figure.name.substr(0, dot); name.find('/') == std::string::npos)
                found.insert(name);
        }
    }
    return {found.begin(), found.end()};
}

namespace {

constexpr const char* this_machine = "host";

/// Returns ns beyond a load that the first level answers, for each further level and for memory, of the
/// machine that measured the store; empty if it did not measure them.
std::vector<double> latencies_of(const ReportData& data) {
    const auto json = input::json_or_null(data.meta_value(store::latencies_key + data.build.id).value_or(""));
    std::vector<double> latencies;
    for (const auto& ns : json)
        if (ns.is_number()) latencies.push_back(ns.get<double>());
    return latencies;
}

/// Returns what a query's misses of this machine's levels wait for, each for the level that answers it.
std::optional<double> waiting_ns(const ReportCell& cell, const std::vector<std::string>& levels,
                                 const std::vector<double>& latencies, bool warm) {
    double ns = 0, deeper = 0;
    for (std::size_t i = latencies.size(); i-- > 0;) {
        const store::StartNames misses = store::level_misses.of(this_machine, levels[i]);
        const auto missed = cell.figure(warm ? misses.warm() : misses.all).value;
        if (!missed) return std::nullopt;
        ns += (*missed - deeper) * latencies[i], deeper = *missed;
    }
    return ns;
}

/// Fills the last two columns, the memory time of all queries and of warm ones, from this machine's
/// latencies.
void add_waiting(const ReportData& data, const std::vector<std::string>& levels, TextGrid& grid) {
    const std::vector<double> latencies = latencies_of(data);
    if (latencies.empty() || latencies.size() > levels.size()) return;
    const std::vector<const ReportCell*> cells = modelled_cells(data);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (const bool warm : {false, true})
            if (const auto ns = waiting_ns(*cells[i], levels, latencies, warm))
                *(grid.rows[i].end() - 2 + warm) = grid_cell(number_text(*ns));
    }
    std::string costs;
    for (std::size_t i = 0; i < latencies.size(); ++i)
        append(costs, fmt::format("{} ns in {}", number_text(latencies[i]),
                                  i + 1 < latencies.size() ? levels[i + 1] : "memory"));
    grid.caption += "; a load that L1D does not answer waits, measured on this machine, " + costs;
}

}  // namespace

TextGrid misses_grid(const ReportData& data, const std::string& machine) {
    const std::vector<std::string> levels = levels_of(data, machine);
    std::vector<FigureColumn> columns;
    for (const std::string& level : levels)
        columns.push_back({fmt::format("{} {}", machine, level), store::level_misses.all.of(machine, level)});
    columns.push_back({machine + " memory, ns", store::memory_time.all.of(machine)});
    columns.push_back({machine + " memory, ns (warm starts)", store::memory_time.of(machine).warm()});
    TextGrid grid =
        cache_grid(data,
                   "Misses per query in the steady pass, by machine and level, of all queries, a pair's cold "
                   "first one too; memory time is a "
                   "model, with * one of latencies that no source proves",
                   columns);
    if (machine == this_machine) add_waiting(data, levels, grid);
    return grid;
}

TextGrid causes_grid(const ReportData& data, const std::string& machine) {
    const FigureColumn of_level[] = {
        {"compulsory (first pass)", "caches.{machine}.{level}.compulsory_per_query"},
        {"all (first pass)", "caches.{machine}.{level}.first_pass_misses_per_query"},
        {"all (emptied)", "caches.{machine}.{level}.emptied_misses_per_query"},
        {"capacity", "caches.{machine}.{level}.capacity_per_query"},
        {"conflict", "caches.{machine}.{level}.conflict_per_query"},
        {"all per edge", "caches.{machine}.{level}.misses_per_edge"}};
    const std::vector<std::string> levels = levels_of(data, machine);
    std::vector<FigureColumn> columns;
    for (const std::string& level : levels)
        for (const FigureColumn& column : of_level)
            columns.push_back({level + " " + column.title, column.figure.of(machine, level)});
    constexpr store::FigureName fetched("caches.{machine}.fetched_bytes_per_query"),
        unused("caches.{machine}.unused_bytes_per_query");
    columns.push_back({"bytes brought in", fetched.of(machine)});
    columns.push_back({"never used", unused.of(machine)});
    return cache_grid(data, machine + ": misses per query by cause; bytes brought into the first level",
                      columns);
}

std::vector<std::string> broken_down_levels(const ReportData& data, const std::string& machine) {
    std::vector<std::string> levels;
    for (const std::string& level : levels_of(data, machine)) {
        if (!breakdown_grid(data, machine, level, misses_by_step).rows.empty()) levels.push_back(level);
    }
    return levels;
}

TextGrid breakdown_grid(const ReportData& data, const std::string& machine, const std::string& level,
                        const store::FigureName& by) {
    const store::FigureName all = by.of(machine, level);
    std::set<std::string> parts;
    for (const ReportCell* cell : modelled_cells(data)) {
        for (const store::FigureRow& figure : cell->figures)
            if (const auto part = all.value_in(figure.probe, figure.name)) parts.insert(*part);
    }
    if (parts.empty()) return {};
    std::vector<FigureColumn> columns;
    for (const std::string& part : parts) columns.push_back({part, by.of(machine, level, part)});
    const bool by_field = &by.info() == &misses_by_field.info();
    TextGrid grid = cache_grid(data,
                               fmt::format("{} {}: misses per query, by {}; a dash: not accessed", machine,
                                           level, by_field ? "what was read" : "what read it"),
                               columns);
    for (std::vector<GridCell>& row : grid.rows)
        for (GridCell& cell : row)
            if (!cell.why.empty()) cell = {"–"};
    return grid;
}

TextGrid working_sets_grid(const ReportData& data) {
    constexpr double lines = 64.0 / 1024, pages = 4;  // KiB
    const FigureColumn columns[] = {{"query, lines", "reuse.lines_per_query"},
                                    {"cold query, lines", store::reuse_names[0].per_query.cold()},
                                    {"warm query, lines", store::reuse_names[0].per_query.warm()},
                                    {"query, pages", "reuse.pages_per_query"},
                                    {"frame, KiB", "reuse.lines_of_frame", 1 / lines},
                                    {"body, KiB", "reuse.lines_of_body", 1 / lines},
                                    {"scene, KiB", "reuse.lines_of_scene", 1 / lines},
                                    {"scene, KiB in pages", "reuse.pages_of_scene", 1 / pages},
                                    {"line knee, KiB", "reuse.line_knee_bytes", kibibyte},
                                    {"page knee, KiB", "reuse.page_knee_bytes", kibibyte},
                                    {"part of tables", "heat.touched_part"},
                                    {"vertices", "heat.touched_vertices"},
                                    {"edges", "heat.touched_edges"},
                                    {"faces", "heat.touched_faces"},
                                    {"lines of half", "heat.lines_of_half_the_accesses"},
                                    {"lines of 90 %", "heat.lines_of_most_accesses"}};
    return cache_grid(data, "Working sets, knees, and what was ever touched", columns);
}

TextGrid policy_grid(const ReportData& data) {
    TextGrid grid{
        "Does a replacement policy or a prefetcher change the ranking by misses? (LRU without prefetching first)",
        columns_of("scene|shape|algorithm|machine and policy|level|#pairs of tables|#in another order|"
                   "ranking changes|first example (misses under LRU, under the policy)")};
    std::map<PolicyGroup, std::vector<Ranked>> groups;
    for (const ReportCell* cell : modelled_cells(data)) {
        for (const auto& [policy, level] : policy_levels(*cell)) {
            const std::string machine = policy.substr(0, policy.find('/'));
            const auto lru = cell->figure(store::level_misses.all.of(machine, level)).value;
            const auto other = cell->figure(store::level_misses.all.of(policy, level)).value;
            if (lru && other)
                groups[{cell->scene_label, cell->shape, cell->algorithm, policy, level}].push_back(
                    {cell->table, *lru, *other});
        }
    }
    for (const auto& [group, tables] : groups) grid.rows.push_back(policy_row(group, tables));
    return grid;
}

}  // namespace edgewise::reports
