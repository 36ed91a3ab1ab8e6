// SPDX-License-Identifier: MIT
//
// Tables about the cells themselves: scenes, problems, the full list.
#include <algorithm>
#include <map>
#include <set>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

/// Cells of one shape with one reason: a mesh that is not there is one problem, not hundreds.
struct Problem {
    std::set<std::string> scenes, algorithms, tables;
    std::size_t cells = 0;
};

/// The name, or how many there are.
std::string one_or_many(const std::set<std::string>& names, const char* noun) {
    return names.size() == 1 ? *names.begin() : plural(names.size(), noun);
}

void add_status(TextGrid& grid, const ReportData& data, store::CellStatus status) {
    std::vector<std::pair<std::string, std::string>> order;
    std::map<std::pair<std::string, std::string>, Problem> problems;
    for (const auto* rows : {&data.cells, &data.from_files, &data.stability, &data.paging, &data.effort,
                             &data.fields, &data.other_studies}) {
        for (const ReportCell& row : *rows) {
            if (row.status != status) continue;
            const auto key = std::make_pair(row.shape, row.reason);
            Problem& problem = problems[key];
            if (problem.cells++ == 0) order.push_back(key);
            problem.scenes.insert(row.scene_label);
            problem.algorithms.insert(row.algorithm);
            problem.tables.insert(row.table);
        }
    }
    for (const auto& key : order) {
        const Problem& problem = problems[key];
        grid.add(to_string(status), problem.cells, one_or_many(problem.scenes, "scene"), key.first,
                 one_or_many(problem.algorithms, "algorithm"), one_or_many(problem.tables, "table type"),
                 key.second.empty() ? std::string("no reason stored") : key.second);
    }
}

}  // namespace

const store::QueryTime& times_of(PairKind kind) {
    return kind == PairKind::Separated ? store::separated_time : store::overlapping_time;
}

std::string pair_name(PairKind kind) { return kind == PairKind::Separated ? "separated" : "overlapping"; }

std::vector<const ReportCell*> verified_cells(const ReportData& data, const std::string& shape,
                                              const std::string& scene_label) {
    std::vector<const ReportCell*> cells;
    for (const ReportCell* cell : data.swept())
        if (cell->verified() && (shape.empty() || cell->shape == shape) &&
            (scene_label.empty() || cell->scene_label == scene_label))
            cells.push_back(cell);
    return cells;
}

std::vector<std::string> scene_labels(const ReportData& data) {
    std::vector<std::string> labels;
    for (const ReportCell* cell : data.swept())
        if (std::find(labels.begin(), labels.end(), cell->scene_label) == labels.end())
            labels.push_back(cell->scene_label);
    return labels;
}

std::vector<std::pair<std::int64_t, std::string>> shapes_by_vertices(const ReportData& data) {
    std::set<std::pair<std::int64_t, std::string>> shapes;
    for (const ReportCell* cell : data.swept()) shapes.emplace(cell->vertices, cell->shape);
    return {shapes.begin(), shapes.end()};
}

TextGrid scenes_grid(const ReportData& data) {
    TextGrid grid{"", columns_of("scene|parameters|#cells|#queries per cell")};
    for (const std::string& label : scene_labels(data)) {
        std::size_t cells = 0;
        std::int64_t least = 0, most = 0;
        std::string parameters;
        for (const ReportCell* cell : data.swept()) {
            if (cell->scene_label != label) continue;
            least = cells == 0 ? cell->queries : std::min(least, cell->queries);
            most = std::max(most, cell->queries);
            parameters = cell->scene_parameters;
            ++cells;
        }
        const std::string queries =
            least == most ? std::to_string(most) : std::to_string(least) + " to " + std::to_string(most);
        grid.add(label, parameters, cells, queries);
    }
    return grid;
}

TextGrid problems_grid(const ReportData& data) {
    TextGrid grid{"", columns_of("status|#cells|scene|shape|algorithm|table type|reason")};
    add_status(grid, data, store::CellStatus::failed);
    add_status(grid, data, store::CellStatus::unavailable);
    return grid;
}

TextGrid cells_grid(const ReportData& data) {
    constexpr const char* names =
        "scene|shape|source|#vertices|#edges|#faces|algorithm|table type|#seed|#queries|status|cell";
    return cell_grid("", names, std::vector<FigureColumn>(), data.swept());
}

}  // namespace edgewise::reports
