// SPDX-License-Identifier: MIT
//
// What each need costs: times with the axis `needs` over the plain cell's, which gives witness points.
#include <map>
#include <tuple>

#include "edgewise/reports/paper/chapter/paper_tables.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

constexpr const char* needs[] = {"verdict", "distance", "features", "depth", "certificate"};

/// Axes -> cell, of one shape, algorithm, layout and precision.
using ByAxes = std::map<std::string, const ReportCell*>;
using Groups = std::map<std::tuple<std::int64_t, std::string, std::string, std::string>, ByAxes>;

Groups groups_of(const StoredScene& scene) {
    Groups groups;
    for (const ReportCell* cell : scene.cells)
        groups[{cell->vertices, cell->shape, cell->algorithm, cell->layout + "_" + cell->precision}]
              [cell->axes] = cell;
    return groups;
}

GridCell needs_ratio_of(const ByAxes& cells, const std::string& need, const store::FigureName& time) {
    const auto cell = cells.find("needs=" + need), plain = cells.find("");
    if (cell == cells.end()) return missing_cell("the store has no cell with needs=" + need);
    const measure::Figure ns = cell->second->figure(time);
    if (!ns.value) return figure_cell(ns);
    if (plain == cells.end()) return missing_cell("the store has no plain cell to compare with");
    return ratio_cell(ns, plain->second->figure(time));
}

}  // namespace

TextGrid needs_grid(const ReportData& data) {
    TextGrid grid{"What each need costs: time over that of witness points, the plain cell",
                  columns_of("shape|algorithm|table type|pairs|#witnesses, ns"),
                  {}};
    for (const char* need : needs) grid.columns.push_back({need, true});
    for (const auto& [key, cells] : groups_of(scene_file(data, "paper_needs"))) {
        const auto& [vertices, shape, algorithm, table] = key;
        const auto plain = cells.find("");
        for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
            const store::FigureName& time = times_of(kind).ns;
            std::vector<GridCell> row = grid_row(shape, algorithm, table, pair_name(kind));
            row.push_back(plain == cells.end() ? missing_cell("the store has no plain cell")
                                               : figure_cell(plain->second->figure(time)));
            for (const char* need : needs) row.push_back(needs_ratio_of(cells, need, time));
            grid.rows.push_back(std::move(row));
        }
    }
    return grid;
}

}  // namespace edgewise::reports
