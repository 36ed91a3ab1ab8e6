// SPDX-License-Identifier: MIT
//
// What the paper leaves open, and what it decides: the margin by which boxes are larger than bodies, and so
// how far apart pairs are that are asked; and its tolerance, some 1e-5, below which bodies are in contact.
// One is changed, all else left.
#include <map>
#include <string>
#include <tuple>

#include "edgewise/reports/paper/chapter/paper_tables.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

/// Two cells that differ in one thing, null where one is not stored.
struct CellPair {
    const ReportCell *first = nullptr, *second = nullptr;
};

/// A figure of the first over the same of the second.
GridCell quotient_of(const CellPair& pair, const store::FigureName& name) {
    return ratio_cell(pair.first, name, pair.second, name);
}

void add_margins(const StoredScene& scene, TextGrid& grid) {
    std::map<std::tuple<std::int64_t, std::string, double>, CellPair> pairs;
    for (const ReportCell* cell : scene.cells) {
        const auto margin = scene_number(*cell, "margin");
        if (!margin || cell->table != "aos_f64") continue;
        CellPair& pair = pairs[{cell->vertices, cell->shape, *margin}];
        (cell->algorithm == "vclip" ? pair.first : pair.second) = cell;
    }
    for (const auto& [key, pair] : pairs) {
        const auto& [vertices, shape, margin] = key;
        const ReportCell* const any = pair.first ? pair.first : pair.second;
        grid.add(scene.name, shape, number_text(margin), any->queries,
                 ratio_cell(any, "error.overlapping", any, "error.checked"),
                 figure_cell(any, "work.first_share"), figure_cell(pair.first, store::all_time.ns),
                 figure_cell(pair.second, store::all_time.ns), quotient_of(pair, store::all_time.ratio));
    }
}

}  // namespace

TextGrid margin_grid(const ReportData& data) {
    TextGrid grid{
        "What the margin of the boxes decides (aos_f64, all pairs as they come; of followed pairs "
        "the queries that start warm)",
        columns_of("scene|shape|#margin, box diagonals|#queries|#overlapping, of checked|"
                   "#first queries, of all|#V-Clip, ns|#Enhanced GJK, ns|#V-Clip / GJK")};
    for (const char* name : {"paper_margin", "paper_static_margin"})
        add_margins(scene_file(data, name), grid);
    return grid;
}

TextGrid tolerance_grid(const ReportData& data) {
    TextGrid grid{"The paper's tolerance of 1e-5 beside none (aos_f64; queries that start warm)",
                  columns_of("shape|#rad per step|algorithm|#ns, none|#ns, 1e-5|#1e-5 / none|#steps, none|"
                             "#steps, 1e-5|#separated, none|#separated, 1e-5|#wrong verdicts, 1e-5")};
    std::map<std::tuple<std::int64_t, std::string, double, std::string>, CellPair> pairs;
    for (const ReportCell* cell : scene_file(data, "paper_tolerance").cells) {
        const auto step = scene_number(*cell, "rotation_step");
        if (!step) continue;
        CellPair& pair = pairs[{cell->vertices, cell->shape, *step, cell->algorithm}];
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
        grid.add(shape, number_text(step), algorithm, ns, ns_with, quotient_of(pair, store::all_time.ratio),
                 steps, steps_with, separated, separated_with,
                 figure_cell(pair.first, "error.wrong_verdicts"));
    }
    return grid;
}

}  // namespace edgewise::reports
