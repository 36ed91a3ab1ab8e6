// SPDX-License-Identifier: MIT
//
// See cache_tables.hpp. Which machines and levels there are is read off the figures' names:
// MACHINE.LEVEL.WHAT, or MACHINE/POLICY.LEVEL.WHAT.
#include "edgewise/reports/tables/cache_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

struct TitledFigure {
    store::FigureName name;
    const char* title;
};

/// The levels of a machine, as the figures of any cell name them: caches from the first on, then TLBs.
std::vector<std::string> levels_of(const ReportData& data, const std::string& machine) {
    std::set<std::pair<bool, std::string>> found;
    for (const ReportCell& cell : data.cells) {
        for (const store::FigureRow& figure : cell.figures) {
            if (const auto level = store::level_misses.of(machine).value_in(figure.probe, figure.name))
                found.insert({level->find("TLB") != std::string::npos, *level});
        }
    }
    std::vector<std::string> levels;
    for (const auto& [is_tlb, level] : found) levels.push_back(level);
    return levels;
}

std::vector<GridColumn> naming_columns() { return columns_of("scene|shape|algorithm|table type"); }
std::vector<GridCell> naming(const ReportCell& cell) {
    return grid_row(cell.scene_label, cell.shape, cell.algorithm, cell.table);
}

GridCell cache_scaled(const measure::Figure& figure, double unit) {
    if (!figure.value) return figure_cell(figure);
    return {number_text(*figure.value / unit)};
}

/// A figure of the probe `caches`; a star where the machine's description marks it as unverified.
GridCell cache_cell(const ReportCell& cell, const std::string& name) {
    const measure::Figure figure = cell.figure(store::level_misses.probe(), name);
    GridCell text = figure_cell(figure);
    if (figure.value && figure.unit.find("unverified") != std::string::npos) text.text += " *";
    return text;
}

double sort_key(const ReportCell& cell) {
    const measure::Figure lines = cell.figure("reuse.lines_per_query");
    return lines.value.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

std::vector<const ReportCell*> modelled_cells(const ReportData& data) {
    std::vector<const ReportCell*> cells;
    for (const ReportCell& cell : data.cells) {
        if (cell.verified() && cell.figure("reuse.line_knee_bytes").value) cells.push_back(&cell);
    }
    std::stable_sort(cells.begin(), cells.end(), [](const ReportCell* a, const ReportCell* b) {
        return std::make_tuple(a->scene_label, a->vertices, b->algorithm, sort_key(*a)) <
               std::make_tuple(b->scene_label, b->vertices, a->algorithm, sort_key(*b));
    });
    return cells;
}

std::vector<std::string> modelled_machines(const ReportData& data) {
    std::set<std::string> found;
    for (const ReportCell& cell : data.cells) {
        for (const store::FigureRow& figure : cell.figures) {
            const std::size_t dot = figure.name.find('.');
            if (figure.probe != "caches" || dot == std::string::npos) continue;
            if (const std::string name = figure.name.substr(0, dot); name.find('/') == std::string::npos)
                found.insert(name);
        }
    }
    return {found.begin(), found.end()};
}

TextGrid misses_grid(const ReportData& data) {
    TextGrid grid{
        "Misses per query in the steady pass, by machine and level; memory time is a model, with * one of "
        "latencies "
        "that no source proves",
        naming_columns(),
        {}};
    std::vector<std::string> names;
    for (const std::string& machine : modelled_machines(data)) {
        for (const std::string& level : levels_of(data, machine)) {
            grid.columns.push_back({fmt::format("{} {}", machine, level), true});
            names.push_back(store::level_misses.of(machine, level).name());
        }
        grid.columns.push_back({machine + " memory, ns", true});
        names.push_back(store::memory_time.of(machine).name());
    }
    for (const ReportCell* cell : modelled_cells(data)) {
        std::vector<GridCell> row = naming(*cell);
        for (const std::string& name : names) row.push_back(cache_cell(*cell, name));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

TextGrid causes_grid(const ReportData& data, const std::string& machine) {
    TextGrid grid{fmt::format("{}: misses per query by cause; bytes brought into the first level", machine),
                  naming_columns(),
                  {}};
    std::vector<std::string> names;
    const TitledFigure columns[] = {{"caches.{machine}.{level}.compulsory_per_query", "compulsory (warm)"},
                                    {"caches.{machine}.{level}.warm_misses_per_query", "all (warm)"},
                                    {"caches.{machine}.{level}.cold_misses_per_query", "all (cold)"},
                                    {"caches.{machine}.{level}.capacity_per_query", "capacity"},
                                    {"caches.{machine}.{level}.conflict_per_query", "conflict"},
                                    {"caches.{machine}.{level}.misses_per_edge", "all per edge"}};
    for (const std::string& level : levels_of(data, machine)) {
        for (const auto& [name, title] : columns) {
            grid.columns.push_back({fmt::format("{} {}", level, title), true});
            names.push_back(name.of(machine, level).name());
        }
    }
    const TitledFigure bytes[] = {{"caches.{machine}.fetched_bytes_per_query", "bytes brought in"},
                                  {"caches.{machine}.unused_bytes_per_query", "never used"}};
    for (const auto& [name, title] : bytes) {
        grid.columns.push_back({title, true});
        names.push_back(name.of(machine).name());
    }
    for (const ReportCell* cell : modelled_cells(data)) {
        std::vector<GridCell> row = naming(*cell);
        for (const std::string& name : names) row.push_back(cache_cell(*cell, name));
        grid.rows.push_back(std::move(row));
    }
    return grid;
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
    TextGrid grid{fmt::format("{} {}: misses per query, by {}; a dash: not accessed", machine, level,
                              &by.info() == &misses_by_field.info() ? "what was read" : "what read it"),
                  naming_columns(),
                  {}};
    if (parts.empty()) return grid;
    for (const std::string& part : parts) grid.columns.push_back({part, true});
    for (const ReportCell* cell : modelled_cells(data)) {
        std::vector<GridCell> row = naming(*cell);
        for (const std::string& part : parts) {
            const measure::Figure figure = cell->figure(by.of(machine, level, part));
            row.push_back({figure.value ? number_text(*figure.value) : "–"});
        }
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

TextGrid working_sets_grid(const ReportData& data) {
    constexpr double kibibyte = 1024, lines = 64.0 / 1024, pages = 4;
    struct Column {
        const char* title;
        store::FigureName figure;
        double unit;
    };
    const Column columns[] = {{"query, lines", "reuse.lines_per_query", 1},
                              {"query, pages", "reuse.pages_per_query", 1},
                              {"frame, KiB", "reuse.lines_of_frame", 1 / lines},
                              {"body, KiB", "reuse.lines_of_body", 1 / lines},
                              {"scene, KiB", "reuse.lines_of_scene", 1 / lines},
                              {"scene, KiB in pages", "reuse.pages_of_scene", 1 / pages},
                              {"line knee, KiB", "reuse.line_knee_bytes", kibibyte},
                              {"page knee, KiB", "reuse.page_knee_bytes", kibibyte},
                              {"part of tables", "heat.touched_part", 1},
                              {"vertices", "heat.touched_vertices", 1},
                              {"edges", "heat.touched_edges", 1},
                              {"faces", "heat.touched_faces", 1},
                              {"lines of half", "heat.lines_of_half_the_accesses", 1},
                              {"lines of 90 %", "heat.lines_of_most_accesses", 1}};
    TextGrid grid{"Working sets, knees, and what was ever touched", naming_columns(), {}};
    for (const Column& column : columns) grid.columns.push_back({column.title, true});
    for (const ReportCell* cell : modelled_cells(data)) {
        std::vector<GridCell> row = naming(*cell);
        for (const Column& column : columns)
            row.push_back(cache_scaled(cell->figure(column.figure), column.unit));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

}  // namespace edgewise::reports
