// SPDX-License-Identifier: MIT
//
// Tables about the cells themselves: scenes, problems, the full list.
#include <algorithm>

#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

std::vector<GridCell> problem_row(const ReportCell& cell) {
    return {{cell.status},    {cell.scene_label}, {cell.shape},
            {cell.algorithm}, {cell.table},       {cell.reason.empty() ? "no reason stored" : cell.reason}};
}

void add_status(TextGrid& grid, const ReportData& data, const std::string& status) {
    for (const auto* rows : {&data.cells, &data.from_files, &data.stability, &data.paging}) {
        for (const ReportCell& row : *rows)
            if (row.status == status) grid.rows.push_back(problem_row(row));
    }
}

}  // namespace

const store::QueryTime& times_of(PairKind kind) {
    return kind == PairKind::Separated ? store::separated_time : store::overlapping_time;
}

std::string pair_name(PairKind kind) { return kind == PairKind::Separated ? "separated" : "overlapping"; }

std::vector<std::string> scene_labels(const ReportData& data) {
    std::vector<std::string> labels;
    for (const ReportCell& cell : data.cells)
        if (std::find(labels.begin(), labels.end(), cell.scene_label) == labels.end())
            labels.push_back(cell.scene_label);
    return labels;
}

TextGrid scenes_grid(const ReportData& data) {
    TextGrid grid{"", {{"scene"}, {"parameters"}, {"cells", true}, {"queries a cell", true}}, {}};
    for (const std::string& label : scene_labels(data)) {
        std::size_t cells = 0;
        std::int64_t least = 0, most = 0;
        std::string parameters;
        for (const ReportCell& cell : data.cells) {
            if (cell.scene_label != label) continue;
            least = cells == 0 ? cell.queries : std::min(least, cell.queries);
            most = std::max(most, cell.queries);
            parameters = cell.scene_parameters;
            ++cells;
        }
        const std::string queries =
            least == most ? std::to_string(most) : std::to_string(least) + " to " + std::to_string(most);
        grid.rows.push_back({{label}, {parameters}, {std::to_string(cells)}, {queries}});
    }
    return grid;
}

TextGrid problems_grid(const ReportData& data) {
    TextGrid grid{"", {{"status"}, {"scene"}, {"shape"}, {"algorithm"}, {"table type"}, {"reason"}}, {}};
    add_status(grid, data, "failed");
    add_status(grid, data, "unavailable");
    return grid;
}

TextGrid cells_grid(const ReportData& data) {
    TextGrid grid{"",
                  {{"scene"},
                   {"shape"},
                   {"source"},
                   {"V", true},
                   {"E", true},
                   {"F", true},
                   {"algorithm"},
                   {"table type"},
                   {"seed", true},
                   {"queries", true},
                   {"status"},
                   {"cell"}},
                  {}};
    for (const ReportCell& cell : data.cells)
        grid.rows.push_back({{cell.scene_label},
                             {cell.shape},
                             {cell.shape_source},
                             {std::to_string(cell.vertices)},
                             {std::to_string(cell.edges)},
                             {std::to_string(cell.faces)},
                             {cell.algorithm},
                             {cell.table},
                             {std::to_string(cell.seed)},
                             {std::to_string(cell.queries)},
                             {cell.status},
                             {cell.hash.substr(0, 12)}});
    return grid;
}

}  // namespace edgewise::reports
