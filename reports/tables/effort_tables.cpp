// SPDX-License-Identifier: MIT
//
// Effort of queries of Edgewise and of other libraries, as the effort run counted it. Rows are ordered by
// instructions, fewest first, and compared with the least that a proof needs.
#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

constexpr const char* names = "scene|shape|algorithm or library|table type or precision";

double instructions(const ReportCell& row) {
    return row.figure("effort.instructions").value.value_or(std::numeric_limits<double>::infinity());
}

/// Rows that were measured at all, by scene and shape; those that were not counted go last.
std::vector<const ReportCell*> in_order(const ReportData& data) {
    std::vector<const ReportCell*> rows;
    for (const ReportCell& row : data.effort)
        if (row.is_timed()) rows.push_back(&row);
    std::ranges::stable_sort(rows, [](const ReportCell* a, const ReportCell* b) {
        return std::tuple(a->scene_label, a->vertices, a->shape, instructions(*a)) <
               std::tuple(b->scene_label, b->vertices, b->shape, instructions(*b));
    });
    return rows;
}

/// Names of the machines with simulated caches, in order.
std::vector<std::string> machines_of(const ReportData& data) {
    constexpr store::FigureName misses("effort.{machine}.d1_misses");
    std::vector<std::string> machines;
    for (const ReportCell& row : data.effort) {
        for (const store::FigureRow& figure : row.figures)
            if (auto machine = misses.value_in(figure.probe, figure.name))
                machines.push_back(std::move(*machine));
    }
    std::ranges::sort(machines);
    machines.erase(std::unique(machines.begin(), machines.end()), machines.end());
    return machines;
}

/// `machines` must outlive the columns.
std::vector<FigureColumn> spent_columns(const std::vector<std::string>& machines) {
    constexpr store::FigureName d1("effort.{machine}.d1_misses"), ll("effort.{machine}.ll_misses");
    std::vector<FigureColumn> columns = {{"instructions", "effort.instructions"},
                                         {"mispredictions, modelled", "effort.mispredictions"}};
    for (const std::string& machine : machines) {
        columns.push_back({"D1 misses, " + machine, d1.of(machine)});
        columns.push_back({"LL misses", ll.of(machine)});
    }
    const FigureColumn rest[] = {{"bytes of a table", "bytes.table_bytes"},
                                 {"of its object", "bytes.object_bytes"},
                                 {"of a pair", "bytes.pair_bytes"},
                                 {"steps", "effort.steps"},
                                 {"supports", "effort.supports"},
                                 {"vertices read", "effort.vertices_read"},
                                 {"lines read", "effort.lines_read"},
                                 {"instructions per step", "effort.instructions_per_step"},
                                 {"mispredictions per step", "effort.mispredictions_per_step"},
                                 {"vertices per step", "effort.vertices_per_step"}};
    columns.insert(columns.end(), std::begin(rest), std::end(rest));
    return columns;
}

}  // namespace

TextGrid effort_grid(const ReportData& data) {
    const std::vector<std::string> machines = machines_of(data);
    return cell_grid("Per query of all queries, fewest instructions first", names, spent_columns(machines),
                     in_order(data));
}

TextGrid effort_floor_grid(const ReportData& data) {
    const FigureColumn columns[] = {{"flops of the floor", "effort.floor_flops"},
                                    {"its vertices", "effort.floor_vertices"},
                                    {"its lines", "effort.floor_lines"},
                                    {"instructions per flop of it", "effort.instructions_over_floor"},
                                    {"vertices read over its own", "effort.vertices_over_floor"},
                                    {"lines read over its own", "effort.lines_over_floor"}};
    return cell_grid("The floor: a proof of the known answer by heights of vertices", names, columns,
                     in_order(data));
}

}  // namespace edgewise::reports
