// SPDX-License-Identifier: MIT
//
// The fronts of time and error as tables: who is on one, and who could not be placed.
#include <map>
#include <tuple>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/fronts.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

const std::string& front_name(const ReportCell& cell) { return cell.judged() ? cell.layout : cell.algorithm; }

const std::string& front_table(const ReportCell& cell) { return cell.judged() ? cell.precision : cell.table; }

/// Of which errors it is on the front: "p50, worst".
std::string fronts_it_is_on(const FrontPoint& point) {
    std::string list;
    for (std::size_t kind = 0; kind < error_kind_count; ++kind)
        if (point.on_front[kind]) append(list, std::string(error_kinds[kind].title));
    return list;
}

std::vector<GridCell> front_row(const FrontPanel& panel, const FrontPoint& point) {
    const ReportCell& cell = *point.cell;
    std::vector<GridCell> row = grid_row(panel.scene_label, panel.shape, panel.vertices, front_name(cell),
                                         front_table(cell), cell.figure(store::separated_time.ns));
    for (const ErrorKind& kind : error_kinds) row.push_back(grid_cell(cell.figure(kind.figure)));
    for (GridCell& last : grid_row(fronts_it_is_on(point), cell.figure("error.wrong_verdicts"),
                                   cell.figure("error.checked"), panel.points.size()))
        row.push_back(std::move(last));
    return row;
}

}  // namespace

TextGrid front_grid(const ReportData& data, const std::string& shape) {
    TextGrid grid{"On a front of time and error: by scene and shape, fastest first",
                  columns_of("scene|shape|#vertices|algorithm or library|table type or precision|"
                             "#ns per query|#p50 error|#p99.9 error|#worst error|on the front of|"
                             "#wrong verdicts|#checked|#cells compared"),
                  {}};
    for (const FrontPanel& panel : fronts_of(data).panels) {
        if (!shape.empty() && panel.shape != shape) continue;
        for (const FrontPoint& point : panel.points)
            if (point.on_any_front()) grid.rows.push_back(front_row(panel, point));
    }
    return grid;
}

TextGrid left_out_grid(const ReportData& data) {
    std::map<std::tuple<std::string, std::string, std::string>, std::size_t> cells;
    for (const auto& [cell, why] : fronts_of(data).left_out)
        ++cells[{front_name(*cell), front_table(*cell), why}];
    TextGrid grid{"Timed and among no points",
                  columns_of("algorithm or library|table type or precision|#cells|why"),
                  {}};
    for (const auto& [key, count] : cells)
        grid.rows.push_back(grid_row(std::get<0>(key), std::get<1>(key), count, std::get<2>(key)));
    return grid;
}

}  // namespace edgewise::reports
