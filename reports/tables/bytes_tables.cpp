// SPDX-License-Identifier: MIT
//
// The bytes-per-edge table. A table's size does not depend on the motion, so rows that agree over scenes are
// one row.
#include <algorithm>
#include <set>
#include <tuple>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

bool is_component(const store::FigureRow& figure) {
    return figure.probe == "bytes" && figure.unit == "B/edge" && !figure.name.ends_with("_bytes_per_edge");
}

const FigureColumn total_columns[] = {{"total", "bytes.total_bytes_per_edge"},
                                      {"paper's subtotal (slope)", "bytes.paper_bytes_per_edge"},
                                      {"total (slope)", "bytes.slope_bytes_per_edge"},
                                      {"table, bytes", "bytes.table_bytes"}};

/// Largest first; those without a total last.
double sort_total(const ReportCell& cell) {
    return cell.figure("bytes.total_bytes_per_edge").value.value_or(-1);
}

std::string key(const std::vector<GridCell>& row) {
    std::string joined;
    for (const GridCell& cell : row) joined += cell.text + '\x1f' + cell.why + '\x1e';
    return joined;
}

}  // namespace

std::string reference_shape(const ReportData& data) {
    const ReportCell* largest = nullptr;
    for (const ReportCell* cell : data.swept()) {
        if (cell->shape == "sphere386") return cell->shape;
        if (!largest || std::tie(cell->vertices, largest->shape) > std::tie(largest->vertices, cell->shape))
            largest = cell;
    }
    return largest ? largest->shape : "";
}

std::vector<std::string> byte_components(const ReportData& data) {
    std::vector<std::string> order{"voronoi_planes", "edge_geometry", "vertex_coordinates",
                                   "face_planes",    "topology",      "input_order",
                                   "padding"};
    std::set<std::string> present;
    for (const ReportCell* cell : data.swept())
        for (const store::FigureRow& figure : cell->figures)
            if (is_component(figure)) present.insert(figure.name);
    std::erase_if(order, [&](const std::string& name) { return present.erase(name) == 0; });
    order.insert(order.end(), present.begin(), present.end());
    return order;
}

TextGrid bytes_grid(const ReportData& data, const std::string& shape) {
    const std::vector<std::string> components = byte_components(data);
    const bool all_shapes = shape.empty();
    std::string names = all_shapes ? "shape|#edges|algorithm|table type" : "algorithm|table type";
    for (const std::string& name : components) names += "|#" + in_words(name);
    TextGrid grid =
        figure_grid("Bytes per edge of the built tables" + (all_shapes ? std::string() : ", " + shape), names,
                    total_columns);
    std::vector<const ReportCell*> cells = verified_cells(data, shape);
    std::stable_sort(cells.begin(), cells.end(), [](const ReportCell* a, const ReportCell* b) {
        const double total_a = sort_total(*a), total_b = sort_total(*b);
        return std::tie(b->vertices, a->shape, b->algorithm, total_b, a->table) <
               std::tie(a->vertices, b->shape, a->algorithm, total_a, b->table);
    });
    std::set<std::string> seen;
    for (const ReportCell* cell : cells) {
        std::vector<GridCell> row = grid_row(cell->algorithm, cell->table);
        if (all_shapes) row = grid_row(cell->shape, cell->edges, cell->algorithm, cell->table);
        for (const std::string& name : components) row.push_back(figure_cell(cell->figure("bytes", name)));
        add_row(grid, std::move(row), *cell, total_columns);
        if (!seen.insert(key(grid.rows.back())).second) grid.rows.pop_back();
    }
    return grid;
}

}  // namespace edgewise::reports
