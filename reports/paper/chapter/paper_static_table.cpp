// SPDX-License-Identifier: MIT
//
// The static test, and the table of any scene from a file.
#include <fmt/core.h>

#include <map>
#include <tuple>

#include "edgewise/reports/paper/chapter/paper_tables.hpp"
#include "edgewise/reports/paper/charts/rotation_angle.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// The two algorithms on one table type, null where it was not asked for.
struct Sides {
    const ReportCell *vclip = nullptr, *gjk = nullptr;
};
using SidesOfTables = std::map<std::tuple<std::int64_t, std::string, std::string>, Sides>;

SidesOfTables sides_of(const StoredScene& scene) {
    SidesOfTables tables;
    for (const ReportCell* cell : scene.cells) {
        Sides& sides = tables[{cell->vertices, cell->shape, cell->table}];
        if (cell->algorithm == "vclip") sides.vclip = cell;
        if (cell->algorithm == "gjk") sides.gjk = cell;
    }
    return tables;
}

GridCell cell_of(const ReportCell* cell, const store::FigureName& name) {
    if (!cell) return {"–"};
    return figure_cell(cell->figure(name));
}

/// Both relative to the baseline timed in the same rounds: what moved the clock is in neither.
GridCell static_ratio_of(const Sides& sides) {
    if (!sides.vclip || !sides.gjk) return {"–"};
    const measure::Figure vclip = sides.vclip->figure("time.all_ratio"),
                          gjk = sides.gjk->figure("time.all_ratio");
    if (!gjk.value) return figure_cell(gjk);
    if (!vclip.value || *vclip.value <= 0) return figure_cell(vclip);
    return {fmt::format("{:.3f}", *gjk.value / *vclip.value)};
}

GridCell static_place_of(const StoredScene& scene, const ReportCell& cell) {
    if (scene.varied == "rotation_step" && has_random_orientation(cell)) return {"random"};
    const auto place = scene.place(cell);
    return place ? GridCell{number_text(*place)} : missing_cell("its scene parameters do not hold it");
}

}  // namespace

TextGrid static_grid(const ReportData& data) {
    TextGrid grid{"Static test: ns per query, all pairs as they come; building a table separately",
                  {{"shape"},
                   {"vertices", true},
                   {"table type"},
                   {"V-Clip, ns", true},
                   {"Enhanced GJK, ns", true},
                   {"GJK / V-Clip", true},
                   {"V-Clip table, build ns", true},
                   {"GJK table, build ns", true}},
                  {}};
    for (const auto& [key, sides] : sides_of(scene_file(data, "paper_static"))) {
        const auto& [vertices, shape, table] = key;
        grid.rows.push_back(grid_row(shape, vertices, table, cell_of(sides.vclip, "time.all_ns"),
                                     cell_of(sides.gjk, "time.all_ns"), static_ratio_of(sides),
                                     cell_of(sides.vclip, "build.build_ns"),
                                     cell_of(sides.gjk, "build.build_ns")));
    }
    return grid;
}

TextGrid file_scene_grid(const StoredScene& scene) {
    TextGrid grid{scene.name + (scene.note.empty() ? "" : ": " + scene.note),
                  columns_of("shape|algorithm|table type|#ns per query, all|#from|#to|#ratio to baseline|"
                             "#separated, ns|#overlapping, ns"),
                  {}};
    const bool varies = !scene.varied.empty();
    if (varies) grid.columns.insert(grid.columns.begin() + 1, {scene.axis_title(), true});
    for (const ReportCell* cell : scene.cells) {
        std::vector<GridCell> row{{cell->shape}};
        if (varies) row.push_back(static_place_of(scene, *cell));
        row.push_back({cell->algorithm});
        row.push_back({cell->table});
        for (const store::FigureName& name :
             {store::all_time.ns, store::all_time.low, store::all_time.high, store::all_time.ratio,
              store::separated_time.ns, store::overlapping_time.ns})
            row.push_back(figure_cell(cell->figure(name)));
        grid.rows.push_back(std::move(row));
    }
    return grid;
}

}  // namespace edgewise::reports
