// SPDX-License-Identifier: MIT
//
// The paper's robustness metric: the share of verdicts that disagree with a control, here two of them: exact
// arithmetic, and the paper's own, Moore and Wilhelms.
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "edgewise/reports/paper/chapter/paper_chapter.hpp"
#include "edgewise/reports/tables/formatting.hpp"

namespace edgewise::reports {

namespace {

using Cells = std::vector<const ReportCell*>;

/// A sum over the cells that have the figure, or why none has.
struct RobustnessSum {
    std::optional<double> total;
    std::string reason = "no cell";

    RobustnessSum(const Cells& cells, const store::FigureName& name) {
        for (const ReportCell* cell : cells) {
            const measure::Figure figure = cell->figure(name);
            if (figure.value)
                total = total.value_or(0) + *figure.value;
            else
                reason = figure.reason;
        }
    }
};

GridCell count_cell(const RobustnessSum& sum) {
    return sum.total ? GridCell{fmt::format("{:.0f}", *sum.total)} : missing_cell(sum.reason);
}

GridCell percent_cell(const RobustnessSum& part, const RobustnessSum& whole) {
    if (!part.total) return missing_cell(part.reason);
    if (!whole.total || *whole.total <= 0) return missing_cell("nothing was checked");
    if (*part.total == 0) return {"0"};
    return {fmt::format("{:.3g} ({:.0f})", 100 * *part.total / *whole.total, *part.total)};
}

std::vector<GridCell> robustness_row_of(const std::vector<std::string>& names, const Cells& cells) {
    std::vector<GridCell> row;
    for (const std::string& name : names) row.push_back({name});
    const RobustnessSum checked(cells, "error.checked"), asked(cells, "error.control_checked");
    row.push_back(count_cell(checked));
    row.push_back(percent_cell(RobustnessSum(cells, "error.wrong_verdicts"), checked));
    row.push_back(percent_cell(RobustnessSum(cells, "error.verdicts_in_band"), checked));
    row.push_back(count_cell(asked));
    row.push_back(percent_cell(RobustnessSum(cells, "error.control_disagreements"), asked));
    row.push_back(percent_cell(RobustnessSum(cells, "error.control_disagreements_outside_band"), asked));
    return row;
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
    std::vector<GridCell> row = grid_row(raw.scene, raw.shape, raw.table, figure_cell(asked),
                                         figure_cell(wrong), figure_cell(raw.figure(names.wrong_verdicts)),
                                         most_share(wrong, asked), figure_cell(raw.figure(names.cycles)));
    const GridCell none = missing_cell("no such cell");
    row.push_back(hardened ? figure_cell(hardened->figure(names.wrong)) : none);
    row.push_back(hardened ? asked_gjk(*hardened, names) : none);
    return row;
}

}  // namespace

TextGrid robustness_grid(const ReportData& data) {
    TextGrid grid{"Robustness: verdicts that disagree, in % (number), over all table types of a precision",
                  columns_of("scene|algorithm|precision|#N, exact|#wrong outside the band, %|"
                             "#pairs inside the band, %|#N, Moore-Wilhelms|#disagree in all, %|"
                             "#disagree outside the band, %")};
    std::map<std::tuple<std::string, std::string, std::string>, Cells> groups;
    std::map<std::pair<std::string, std::string>, Cells> all;
    for (const ReportCell& cell : data.from_files) {
        // A failed cell counts: its verdicts are what failed.
        if (cell.status == store::CellStatus::unavailable) continue;
        const std::string algorithm = cell.is_raw() ? "vclip, raw" : cell.algorithm;
        groups[{cell.scene, algorithm, cell.precision}].push_back(&cell);
        all[{algorithm, cell.precision}].push_back(&cell);
    }
    for (const auto& [key, cells] : all)
        grid.rows.push_back(robustness_row_of({"all scenes", key.first, key.second}, cells));
    for (const auto& [key, cells] : groups) {
        const auto& [scene, algorithm, precision] = key;
        grid.rows.push_back(robustness_row_of({scene, algorithm, precision}, cells));
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
