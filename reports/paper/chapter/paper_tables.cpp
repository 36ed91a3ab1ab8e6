// SPDX-License-Identifier: MIT
//
// Tables of costs. The paper's cost functions, equations 1 and 2: T = N_v C_v + N_p C_p (+ N_u C_u), each
// term as measured, and their sums next to the measured step. The cost of each need: times with the axis
// `needs` over the plain cell's, which gives witness points; and its reads, nearness next to the other needs,
// over all pairs, since a verdict on nearness does not show which pairs are in contact. Ease of
// implementation: the cost of building the tables.
#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string_view>
#include <tuple>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

const FigureColumn cost_columns[] = {{"N_v box tests", "cost.box_tests_per_step"},
                                     {"C_v, ns", "cost.box_test_ns"},
                                     {"N_p pairs", "cost.pairs_per_step"},
                                     {"C_p, ns", "cost.pair_ns"},
                                     {"N_u boxes", "cost.bodies"},
                                     {"C_u, ns", "cost.update_ns"},
                                     {"equation 1, ns", "cost.equation_1_ns"},
                                     {"equation 2, ns", "cost.equation_2_ns"},
                                     {"measured, ns", "cost.step_ns"}};

bool has_cost(const ReportCell& cell) {
    for (const store::FigureRow& figure : cell.figures)
        if (figure.probe == "cost" && figure.value) return true;
    return false;
}

void add_cost_row(TextGrid& grid, const StoredScene& scene, const ReportCell& cell) {
    const auto place = scene.place(cell);
    add_row(grid,
            grid_row(scene.name, scene.varied.empty() ? cell.shape : scene.axis_title(),
                     place ? number_text(*place) : "–", cell.algorithm),
            cell, cost_columns);
    grid.rows.back().push_back(ratio_cell(cell.figure("cost.equation_2_ns"), cell.figure("cost.step_ns")));
}

constexpr const char* needs[] = {"verdict", "distance", "features", "depth", "certificate"};
constexpr std::string_view margin_mark = ", margin ";

/// Axes -> cell, of one shape, algorithm, layout and precision.
using ByAxes = std::map<std::string, const ReportCell*>;
using Groups = std::map<std::tuple<std::int64_t, std::string, std::string, std::string>, ByAxes>;

Groups groups_of(const StoredScene& scene) {
    Groups groups;
    for (const ReportCell* cell : scene.cells)
        groups[{cell->vertices, cell->shape, cell->algorithm, cell->layout + "_" + cell->precision}]
              [cell->axes] = cell;
    return groups;
}

GridCell needs_ratio_of(const ByAxes& cells, const std::string& need, const store::FigureName& time) {
    const auto cell = cells.find("needs=" + need), plain = cells.find("");
    if (cell == cells.end()) return missing_cell("the store has no cell with needs=" + need);
    const measure::Figure ns = cell->second->figure(time);
    if (!ns.value) return figure_cell(ns);
    if (plain == cells.end()) return missing_cell("the store has no plain cell to compare with");
    return ratio_cell(ns, plain->second->figure(time));
}

/// How a need is named for people: "nearer, margin 0.1".
std::string need_name(const ReportCell& cell) {
    const auto need = cell.axis("needs"), margin = cell.axis("margin");
    if (!need) return "witnesses";
    return margin ? *need + std::string(margin_mark) + *margin : *need;
}

/// Least asked first: nearness by its margins, witnesses behind the distance.
std::vector<const ReportCell*> by_need(const ByAxes& cells) {
    // As in table/needs.hpp, which a report does not see.
    constexpr std::array<std::string_view, 7> order = {"nearer",   "verdict", "distance",   "witnesses",
                                                       "features", "depth",   "certificate"};
    const auto place = [&](const ReportCell* cell) {
        const std::string name = need_name(*cell);
        const std::size_t mark = name.find(margin_mark);
        const std::string margin = mark == name.npos ? "0" : name.substr(mark + margin_mark.size());
        return std::tuple(std::ranges::find(order, name.substr(0, mark)) - order.begin(),
                          std::strtod(margin.c_str(), nullptr), cell->axes);
    };
    std::vector<const ReportCell*> sorted;
    for (const auto& [axes, cell] : cells) sorted.push_back(cell);
    std::ranges::sort(sorted, [&](const ReportCell* a, const ReportCell* b) { return place(a) < place(b); });
    return sorted;
}

}  // namespace

TextGrid cost_grid(const ReportData& data, bool of_bodies) {
    TextGrid grid = figure_grid("Cost functions per step, on the baseline's table type (aos_f64)",
                                "scene|varies|#at|algorithm", cost_columns);
    grid.columns.push_back({"equation 2 / measured", true});
    for (const StoredScene& scene : scene_files(data)) {
        if ((scene.name == "paper_bodies" || scene.name == "paper_bodies_shrinking") != of_bodies) continue;
        for (const ReportCell* cell : scene.cells)
            if (cell->verified() && cell->table == "aos_f64" && has_cost(*cell))
                add_cost_row(grid, scene, *cell);
    }
    return grid;
}

TextGrid needs_grid(const ReportData& data) {
    TextGrid grid{"Cost of each need: time divided by the time for witness points, plain cell",
                  columns_of("shape|algorithm|table type|pairs|#witnesses, ns")};
    for (const char* need : needs) grid.columns.push_back({need, true});
    for (const auto& [key, cells] : groups_of(scene_file(data, "paper_needs"))) {
        const auto& [vertices, shape, algorithm, table] = key;
        const auto plain = cells.find("");
        for (const PairKind kind : {PairKind::Separated, PairKind::Overlapping}) {
            const store::FigureName& time = times_of(kind).ns;
            std::vector<GridCell> row = grid_row(shape, algorithm, table, pair_name(kind));
            row.push_back(plain == cells.end() ? missing_cell("the store has no plain cell")
                                               : figure_cell(plain->second->figure(time)));
            for (const char* need : needs) row.push_back(needs_ratio_of(cells, need, time));
            grid.rows.push_back(std::move(row));
        }
    }
    return grid;
}

TextGrid all_needs_grid(const ReportData& data) {
    TextGrid grid{
        "Cost of each need over all pairs, and cache lines that a query reads of the tables; warm queries "
        "for nearness try the bounds first",
        columns_of("shape|algorithm|table type|need|#ns per query|#over witnesses|#lines per warm query|"
                   "#told by bounds")};
    for (const auto& [key, cells] : groups_of(scene_file(data, "paper_needs"))) {
        const auto& [vertices, shape, algorithm, table] = key;
        const auto plain = cells.find("");
        for (const ReportCell* cell : by_need(cells)) {
            const measure::Figure ns = cell->figure("time.all_ns");
            grid.add(shape, algorithm, table, need_name(*cell), ns,
                     plain == cells.end() ? missing_cell("the store has no plain cell to compare with")
                                          : ratio_cell(ns, plain->second->figure("time.all_ns")),
                     cell->figure(store::lines_read.warm()),
                     figure_cell(cell->figure("work.told_by_bounds"), 1, 3));
        }
    }
    return grid;
}

TextGrid build_grid(const ReportData& data) {
    const FigureColumn columns[] = {{"build, ns", "build.build_ns"},
                                    {"refit, ns", "build.refit_ns"},
                                    {"bytes per edge (slope)", "bytes.paper_bytes_per_edge"},
                                    {"table, bytes", "bytes.table_bytes"}};
    std::vector<const ReportCell*> cells = scene_file(data, "paper_complexity").cells;
    std::erase_if(cells, [](const ReportCell* cell) { return !cell->axes.empty(); });
    return cell_grid(
        "Preprocessing: building a table, and refitting it to a deformed body of the same topology",
        "shape|#vertices|algorithm|table type", columns, cells);
}

// The paper's robustness metric: the share of verdicts that disagree with a control, here two of them: exact
// arithmetic, and the paper's own, Moore and Wilhelms.

namespace {

using Cells = std::vector<const ReportCell*>;

/// A sum over the cells that have the figure, or why none has.
measure::Figure summed(const Cells& cells, const store::FigureName& name) {
    measure::Figure sum{name.name(), std::nullopt, "", "no cell"};
    for (const ReportCell* cell : cells) {
        const measure::Figure figure = cell->figure(name);
        if (figure.value)
            sum.value = sum.value.value_or(0) + *figure.value;
        else
            sum.reason = figure.reason;
    }
    return sum;
}

GridCell percent_cell(const measure::Figure& part, const measure::Figure& whole) {
    if (!part.value) return figure_cell(part);
    if (!whole.value || *whole.value <= 0) return missing_cell("nothing was checked");
    if (*part.value == 0) return {"0"};
    return {fmt::format("{:.3g} ({:.0f})", 100 * *part.value / *whole.value, *part.value)};
}

/// Returns true if `cell` asks the same queries as `raw`, by the same table type, and is hardened.
bool is_hardened_of(const ReportCell& raw, const ReportCell& cell) {
    return !cell.is_raw() && cell.scene == raw.scene && cell.scene_parameters == raw.scene_parameters &&
           cell.shape == raw.shape && cell.seed == raw.seed && cell.algorithm == raw.algorithm &&
           raw.table.starts_with(cell.table);
}

/// Returns the share; if none failed, its bound by the rule of three, with 95 %.
GridCell most_share(const measure::Figure& wrong, const measure::Figure& asked) {
    if (!wrong.value || !asked.value || *asked.value <= 0) return missing_cell(wrong.reason);
    if (*wrong.value == 0) return {fmt::format("{:.2g} (3/n)", 3 / *asked.value)};
    return {fmt::format("{:.2g}", *wrong.value / *asked.value)};
}

/// The names that a cell of a sweep and a row of the stability run share.
struct AnswerNames {
    store::FigureName asked, wrong, wrong_verdicts, cycles, fallbacks, refinements;
};
const AnswerNames of_cells = {"error.checked", "error.wrong_answers", "error.wrong_verdicts",
                              "error.cycles",  "error.fallbacks",     "error.refinements"};
const AnswerNames of_families = {
    "stability.cases",  "stability.wrong_answers", "stability.wrong_outside_band",
    "stability.cycles", "stability.fallbacks",     "stability.refinements"};

/// Returns how often V-Clip took GJK's answer: a fallback and a refinement both count.
GridCell asked_gjk(const ReportCell& hardened, const AnswerNames& names) {
    measure::Figure sum = hardened.figure(names.fallbacks);
    const measure::Figure refined = hardened.figure(names.refinements);
    if (!refined.value) return figure_cell(refined);
    if (sum.value) *sum.value += *refined.value;
    return figure_cell(sum);
}

std::vector<GridCell> raw_row(const ReportCell& raw, const ReportCell* hardened) {
    const AnswerNames& names = raw.run == "stability" ? of_families : of_cells;
    const measure::Figure asked = raw.figure(names.asked), wrong = raw.figure(names.wrong);
    const GridCell none = missing_cell("no such cell");
    return grid_row(raw.scene, raw.shape, raw.table, asked, wrong, raw.figure(names.wrong_verdicts),
                    most_share(wrong, asked), raw.figure(names.cycles),
                    hardened ? figure_cell(hardened->figure(names.wrong)) : none,
                    hardened ? asked_gjk(*hardened, names) : none);
}

}  // namespace

TextGrid robustness_grid(const ReportData& data) {
    TextGrid grid{"Robustness: verdicts that disagree, in % (number), over all table types of a precision",
                  columns_of("scene|algorithm|precision|#N, exact|#wrong outside the band, %|"
                             "#pairs inside the band, %|#N, Moore-Wilhelms|#disagree in all, %|"
                             "#disagree outside the band, %")};
    std::map<std::tuple<bool, std::string, std::string, std::string>, Cells> groups;  // all scenes first
    for (const ReportCell& cell : data.from_files) {
        // A failed cell counts: its verdicts are what failed.
        if (cell.status == store::CellStatus::unavailable) continue;
        const std::string algorithm = cell.is_raw() ? "vclip, raw" : cell.algorithm;
        groups[{false, "all scenes", algorithm, cell.precision}].push_back(&cell);
        groups[{true, cell.scene, algorithm, cell.precision}].push_back(&cell);
    }
    for (const auto& [key, cells] : groups) {
        const auto& [is_one, scene, algorithm, precision] = key;
        const measure::Figure checked = summed(cells, "error.checked"),
                              asked = summed(cells, "error.control_checked");
        grid.add(scene, algorithm, precision, figure_cell(checked, 1, 0),
                 percent_cell(summed(cells, "error.wrong_verdicts"), checked),
                 percent_cell(summed(cells, "error.verdicts_in_band"), checked), figure_cell(asked, 1, 0),
                 percent_cell(summed(cells, "error.control_disagreements"), asked),
                 percent_cell(summed(cells, "error.control_disagreements_outside_band"), asked));
    }
    return grid;
}

TextGrid raw_vclip_grid(const ReportData& data) {
    TextGrid grid{
        "Raw V-Clip (axis hardening=off) and the hardened one, on the same queries; cycles and GJK's "
        "answers are of all queries",
        columns_of("scene|body or family|table type|#independent queries|#raw: wrong answers|"
                   "#raw: wrong verdicts|#share, at most|#raw: cycles|#hardened: wrong answers|"
                   "#hardened: GJK's answers")};
    for (const auto* rows : {&data.from_files, &data.stability}) {
        for (const ReportCell& raw : *rows) {
            if (!raw.is_raw()) continue;
            const auto hardened = std::ranges::find_if(
                *rows, [&](const ReportCell& cell) { return is_hardened_of(raw, cell); });
            grid.rows.push_back(raw_row(raw, hardened == rows->end() ? nullptr : &*hardened));
        }
    }
    return grid;
}

}  // namespace edgewise::reports
