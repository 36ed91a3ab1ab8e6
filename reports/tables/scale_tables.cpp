// SPDX-License-Identifier: MIT
#include "edgewise/reports/tables/scale_tables.hpp"

#include <fmt/core.h>

namespace edgewise::reports {

namespace {

GridCell ratio_of(const ReportCell& cell) {
    const measure::Figure middle = cell.figure("scale.shared_over_own"),
                          low = cell.figure("scale.shared_over_own_low"),
                          high = cell.figure("scale.shared_over_own_high");
    if (!middle.value || !low.value || !high.value) return figure_cell(middle);
    return {fmt::format("{:.2f} [{:.2f}, {:.2f}]", *middle.value, *low.value, *high.value)};
}

}  // namespace

TextGrid scale_grid(const ReportData& data) {
    TextGrid grid{
        "GJK over 64 instances of a body, each at a scale of its own: views of one table beside a table each",
        columns_of("scene|shape|table|#query, shared, ns|#tables of their own, ns|#shared / own|#bytes, "
                   "shared|#bytes, own|#own / shared|#to build one, ns|#to refit it, ns|#worst error"),
        {}};
    for (const ReportCell& cell : data.cells) {
        const measure::Figure shared = cell.figure("scale.shared_query_ns");
        if (!cell.verified() || !shared.value) continue;
        const measure::Figure shared_bytes = cell.figure("scale.shared_bytes"),
                              own_bytes = cell.figure("scale.own_bytes");
        grid.rows.push_back(grid_row(
            cell.scene_label, cell.shape, cell.table, shared, cell.figure("scale.own_query_ns"),
            ratio_of(cell), shared_bytes, own_bytes, ratio_cell(own_bytes, shared_bytes),
            cell.figure("scale.build_ns"), cell.figure("scale.refit_ns"), cell.figure("scale.worst_error")));
    }
    return grid;
}

}  // namespace edgewise::reports
