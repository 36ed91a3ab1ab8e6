// SPDX-License-Identifier: MIT
//
// The paper's ease of implementation: what the algorithms' source says, and what building their tables costs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "edgewise/reports/paper/chapter/paper_tables.hpp"
#include "edgewise/reports/tables/source_facts.hpp"

namespace edgewise::reports {

namespace {

/// What the contract between layouts and algorithms asks of a body (table/contract.hpp).
std::string bodies_accepted(const std::string& algorithm) {
    const std::map<std::string, std::string> accepted{
        {"V-Clip",
         "convex polyhedra with their features: solids, flat polygons, segments, points; planes stored or "
         "derived"},
        {"Enhanced GJK", "convex hulls of points: vertices alone, or with neighbours for hill climbing"},
        {"Moore-Wilhelms", "convex polyhedra: vertices, edges and faces"},
        {"sweep and prune", "boxes of any bodies"},
        {"penetration (EPA)", "what GJK takes, after a query found contact"}};
    const auto found = accepted.find(algorithm);
    return found == accepted.end() ? "–" : found->second;
}

}  // namespace

TextGrid source_grid() {
    TextGrid grid{"Source of each algorithm in this program (no blank and no comment lines)",
                  columns_of("algorithm|#files|#lines of code|#tolerances|which|"
                             "bodies accepted (concave ones by none)"),
                  {}};
    for (const SourceFacts& facts : source_facts())
        grid.rows.push_back(
            grid_row(facts.algorithm, facts.files, facts.code_lines, facts.tolerances.size(),
                     facts.tolerances.empty() ? "–" : fmt::format("{}", fmt::join(facts.tolerances, ", ")),
                     bodies_accepted(facts.algorithm)));
    return grid;
}

TextGrid build_grid(const ReportData& data) {
    const FigureColumn columns[] = {{"build, ns", "build.build_ns"},
                                    {"refit, ns", "build.refit_ns"},
                                    {"bytes per edge (slope)", "bytes.paper_bytes_per_edge"},
                                    {"table, bytes", "bytes.table_bytes"}};
    TextGrid grid = figure_grid(
        "Preprocessing: building a table, and refitting it to a deformed body of the same topology",
        "shape|#vertices|algorithm|table type", columns);
    for (const ReportCell* cell : scene_file(data, "paper_complexity").cells)
        if (cell->axes.empty())
            add_row(grid, grid_row(cell->shape, cell->vertices, cell->algorithm, cell->table), *cell,
                    columns);
    return grid;
}

}  // namespace edgewise::reports
