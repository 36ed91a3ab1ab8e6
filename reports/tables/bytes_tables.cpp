// SPDX-License-Identifier: MIT
//
// The bytes-per-edge table. A table's size does not depend on the motion, so rows that agree over scenes are
// one row.
#include <algorithm>
#include <set>
#include <tuple>

#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

bool is_component(const store::FigureRow& figure) {
    const std::string suffix = "_bytes_per_edge";
    const bool total = figure.name.size() >= suffix.size() &&
                       figure.name.compare(figure.name.size() - suffix.size(), suffix.size(), suffix) == 0;
    return figure.probe == "bytes" && figure.unit == "B/edge" && !total;
}

std::string column_title(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

std::vector<GridCell> bytes_row(const ReportCell& cell, const std::vector<std::string>& components,
                                bool one_shape) {
    std::vector<GridCell> row;
    if (!one_shape) row = {{cell.shape}, {std::to_string(cell.edges)}};
    row.push_back({cell.algorithm});
    row.push_back({cell.table});
    for (const std::string& name : components) row.push_back(figure_cell(cell.figure("bytes", name)));
    for (const store::FigureName& name :
         std::initializer_list<store::FigureName>{"bytes.total_bytes_per_edge", "bytes.paper_bytes_per_edge",
                                                  "bytes.slope_bytes_per_edge", "bytes.table_bytes"})
        row.push_back(figure_cell(cell.figure(name)));
    return row;
}

std::string key(const std::vector<GridCell>& row) {
    std::string joined;
    for (const GridCell& cell : row) joined += cell.text + '\x1f' + cell.why + '\x1e';
    return joined;
}

}  // namespace

std::string reference_shape(const ReportData& data) {
    const ReportCell* largest = nullptr;
    for (const ReportCell& cell : data.cells) {
        if (cell.shape == "sphere386") return cell.shape;
        if (!largest || std::tie(cell.vertices, largest->shape) > std::tie(largest->vertices, cell.shape))
            largest = &cell;
    }
    return largest ? largest->shape : "";
}

std::vector<std::string> byte_components(const ReportData& data) {
    std::vector<std::string> order{"voronoi_planes", "edge_geometry", "vertex_coordinates",
                                   "face_planes",    "topology",      "padding"};
    std::set<std::string> present;
    for (const ReportCell& cell : data.cells)
        for (const store::FigureRow& figure : cell.figures)
            if (is_component(figure)) present.insert(figure.name);
    order.erase(std::remove_if(order.begin(), order.end(),
                               [&](const std::string& name) { return present.erase(name) == 0; }),
                order.end());
    order.insert(order.end(), present.begin(), present.end());
    return order;
}

TextGrid bytes_grid(const ReportData& data, const std::string& shape) {
    const std::vector<std::string> components = byte_components(data);
    TextGrid grid{"Bytes per edge of the built tables" + (shape.empty() ? "" : ", " + shape), {}, {}};
    if (shape.empty()) grid.columns = columns_of("shape|#edges");
    grid.columns.push_back({"algorithm"});
    grid.columns.push_back({"table type"});
    for (const std::string& name : components) grid.columns.push_back({column_title(name), true});
    for (const char* title : {"total", "paper's subtotal (slope)", "total (slope)", "table, bytes"})
        grid.columns.push_back({title, true});
    std::vector<const ReportCell*> cells;
    for (const ReportCell& cell : data.cells)
        if (cell.verified() && (shape.empty() || cell.shape == shape)) cells.push_back(&cell);
    std::stable_sort(cells.begin(), cells.end(), [](const ReportCell* a, const ReportCell* b) {
        return std::tie(b->vertices, a->shape, b->algorithm, a->table) <
               std::tie(a->vertices, b->shape, a->algorithm, b->table);
    });
    std::set<std::string> seen;
    for (const ReportCell* cell : cells) {
        std::vector<GridCell> row = bytes_row(*cell, components, !shape.empty());
        if (seen.insert(key(row)).second) grid.rows.push_back(std::move(row));
    }
    return grid;
}

}  // namespace edgewise::reports
