// SPDX-License-Identifier: MIT
//
// The static test, the table of any scene from a file, and what the paper leaves open or decides: the margin
// by which boxes are larger than bodies, and so how far apart the pairs of queries are; and its tolerance,
// about 1e-5, below which bodies are in contact. One is changed at a time.

#include <map>
#include <string>
#include <tuple>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
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

/// Returns other libraries' cells in GJK's place, with V-Clip on the paper's record; raw V-Clip is not timed.
SidesOfTables sides_with_peers(const StoredScene& scene) {
    SidesOfTables tables = sides_of(scene);
    std::erase_if(tables,
                  [](const auto& entry) { return entry.second.vclip && entry.second.vclip->is_raw(); });
    for (const ReportCell* cell : scene.cells) {
        if (!cell->judged() || cell->is_raw()) continue;
        const auto ours = tables.find({cell->vertices, cell->shape, "aos_f64"});
        tables[{cell->vertices, cell->shape, cell->table}] = {
            ours == tables.end() ? nullptr : ours->second.vclip, cell};
    }
    return tables;
}

/// Both relative to the baseline timed in the same rounds: what moved the clock is in neither.
GridCell static_ratio_of(const Sides& sides) {
    return ratio_cell(sides.gjk, "time.all_ratio", sides.vclip, "time.all_ratio");
}

/// A static pair's query is its first: in a library that keeps pairs in a hash map it makes the entry as
/// well.
GridCell ratio_with_pairs(const Sides& sides) {
    if (!sides.vclip || !sides.gjk) return {"–"};
    const auto sum = [](const ReportCell& cell) {
        measure::Figure time = cell.figure("time.all_ns");
        const measure::Figure pair = cell.figure("pairs.creation_ns");
        if (!pair.value) return pair;
        if (time.value) *time.value += *pair.value;
        return time;
    };
    return ratio_cell(sum(*sides.gjk), sum(*sides.vclip));
}

/// The two algorithms on aos_f64, by vertices, shape and a number of the scene.
auto sides_along(const StoredScene& scene, const char* number) {
    std::map<std::tuple<std::int64_t, std::string, double>, Sides> found;
    for (const ReportCell* cell : scene.cells) {
        const auto value = parameter_of(*cell, number);
        if (!value || cell->table != "aos_f64") continue;
        Sides& sides = found[{cell->vertices, cell->shape, *value}];
        (cell->algorithm == "vclip" ? sides.vclip : sides.gjk) = cell;
    }
    return found;
}

GridCell time_per_step(const ReportCell* cell) {
    return ratio_cell(cell, "time.all_ns", cell, store::mean_steps.cold());
}

GridCell static_place_of(const StoredScene& scene, const ReportCell& cell) {
    if (scene.varied == "rotation_step" && has_random_orientation(cell)) return {"random"};
    const auto place = scene.place(cell);
    return place ? GridCell{number_text(*place)} : missing_cell("its scene parameters do not hold it");
}

}  // namespace

TextGrid static_grid(const ReportData& data) {
    TextGrid grid{"Static test: ns per query, all pairs as they come; building a table separately",
                  columns_of("shape|#vertices|table type|#V-Clip, ns|#Enhanced GJK, ns|#GJK / V-Clip|"
                             "#V-Clip's pair in a hash map, ns|#GJK's pair, ns|#GJK / V-Clip with it|"
                             "#V-Clip table, build ns|#GJK table, build ns")};
    for (const auto& [key, sides] : sides_with_peers(scene_file(data, "paper_static"))) {
        const auto& [vertices, shape, table] = key;
        grid.add(shape, vertices, table, figure_cell(sides.vclip, "time.all_ns"),
                 figure_cell(sides.gjk, "time.all_ns"), static_ratio_of(sides),
                 figure_cell(sides.vclip, "pairs.creation_ns"), figure_cell(sides.gjk, "pairs.creation_ns"),
                 ratio_with_pairs(sides), figure_cell(sides.vclip, "build.build_ns"),
                 figure_cell(sides.gjk, "build.build_ns"));
    }
    return grid;
}

TextGrid static_gap_grid(const ReportData& data) {
    TextGrid grid{
        "Static test by body and distance (aos_f64; pairs without a past, all at one gap): the ratio of "
        "times, and the steps and the time of a step that make it",
        columns_of("shape|#gap, body sizes|#V-Clip, ns|#Enhanced GJK, ns|#GJK / V-Clip|#V-Clip's steps|"
                   "#GJK's iterations|#V-Clip, ns per step|#GJK, ns per iteration")};
    const store::FigureName steps = store::mean_steps.cold();
    for (const auto& [key, sides] : sides_along(scene_file(data, "paper_static_gap"), "gap")) {
        const auto& [vertices, shape, gap] = key;
        grid.add(shape, number_text(gap), figure_cell(sides.vclip, "time.all_ns"),
                 figure_cell(sides.gjk, "time.all_ns"), static_ratio_of(sides),
                 figure_cell(sides.vclip, steps), figure_cell(sides.gjk, steps), time_per_step(sides.vclip),
                 time_per_step(sides.gjk));
    }
    return grid;
}

TextGrid file_scene_grid(const StoredScene& scene) {
    const FigureColumn columns[] = {{"first queries", "work.first_queries"},
                                    {"of all", "work.first_share"},
                                    {"first, ns", store::query_time.cold()},
                                    {"ns per query, all", store::all_time.ns},
                                    {"from", store::all_time.low},
                                    {"to", store::all_time.high},
                                    {"ratio to baseline", store::all_time.ratio},
                                    {"separated, ns", store::separated_time.ns},
                                    {"overlapping, ns", store::overlapping_time.ns}};
    TextGrid grid = figure_grid(scene.name + (scene.note.empty() ? "" : ": " + scene.note),
                                "shape|algorithm|table type", columns);
    const bool varies = !scene.varied.empty();
    if (varies) grid.columns.insert(grid.columns.begin() + 1, {scene.axis_title(), true});
    for (const ReportCell* cell : scene.cells) {
        std::vector<GridCell> row = grid_row(cell->shape, cell->algorithm, cell->table);
        if (varies) row.insert(row.begin() + 1, static_place_of(scene, *cell));
        add_row(grid, std::move(row), *cell, columns);
    }
    return grid;
}

TextGrid margin_grid(const ReportData& data) {
    TextGrid grid{
        "What the margin of the boxes decides (aos_f64, all pairs as they come; of followed pairs "
        "the queries that start warm)",
        columns_of("scene|shape|#margin, box diagonals|#queries|#overlapping, of checked|"
                   "#first queries, of all|#V-Clip, ns|#Enhanced GJK, ns|#V-Clip / GJK")};
    for (const char* name : {"paper_margin", "paper_static_margin"}) {
        for (const auto& [key, sides] : sides_along(scene_file(data, name), "margin")) {
            const auto& [vertices, shape, margin] = key;
            const ReportCell* const any = sides.vclip ? sides.vclip : sides.gjk;
            grid.add(name, shape, number_text(margin), any->queries,
                     ratio_cell(any, "error.overlapping", any, "error.checked"),
                     figure_cell(any, "work.first_share"), figure_cell(sides.vclip, store::all_time.ns),
                     figure_cell(sides.gjk, store::all_time.ns),
                     ratio_cell(sides.vclip, store::all_time.ratio, sides.gjk, store::all_time.ratio));
        }
    }
    return grid;
}

TextGrid tolerance_grid(const ReportData& data) {
    TextGrid grid{"The paper's tolerance of 1e-5 and none (aos_f64; queries that start warm)",
                  columns_of("shape|#rad per step|algorithm|#ns, none|#ns, 1e-5|#1e-5 / none|#steps, none|"
                             "#steps, 1e-5|#separated, none|#separated, 1e-5|#wrong verdicts, 1e-5")};
    using WithAndWithout = std::pair<const ReportCell*, const ReportCell*>;  // null where not stored
    std::map<std::tuple<std::int64_t, std::string, double, std::string>, WithAndWithout> pairs;
    for (const ReportCell* cell : scene_file(data, "paper_tolerance").cells) {
        const auto step = parameter_of(*cell, "rotation_step");
        if (!step) continue;
        WithAndWithout& pair = pairs[{cell->vertices, cell->shape, *step, cell->algorithm}];
        (cell->axes.empty() ? pair.second : pair.first) = cell;
    }
    for (const auto& [key, pair] : pairs) {
        const auto& [vertices, shape, step, algorithm] = key;
        const auto both = [&, of = pair](const store::FigureName& name) {
            return std::pair(figure_cell(of.second, name), figure_cell(of.first, name));
        };
        const auto [ns, ns_with] = both(store::all_time.ns);
        const auto [steps, steps_with] = both(store::mean_steps.warm());
        const auto [separated, separated_with] = both("error.separated");
        grid.add(shape, number_text(step), algorithm, ns, ns_with,
                 ratio_cell(pair.first, store::all_time.ratio, pair.second, store::all_time.ratio), steps,
                 steps_with, separated, separated_with, figure_cell(pair.first, "error.wrong_verdicts"));
    }
    return grid;
}

}  // namespace edgewise::reports
