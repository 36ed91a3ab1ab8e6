// SPDX-License-Identifier: MIT
//
// The paper's robustness metric: the share of verdicts that disagree with a control, here two of them: exact
// arithmetic, and the paper's own, Moore and Wilhelms.
#include <fmt/core.h>

#include <map>
#include <tuple>

#include "edgewise/reports/paper/chapter/paper_tables.hpp"
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

}  // namespace

TextGrid robustness_grid(const ReportData& data) {
    TextGrid grid{"Robustness: verdicts that disagree, in % (number), over all table types of a precision",
                  columns_of("scene|algorithm|precision|#N, exact|#wrong outside the band, %|"
                             "#pairs inside the band, %|#N, Moore-Wilhelms|#disagree in all, %|"
                             "#disagree outside the band, %"),
                  {}};
    std::map<std::tuple<std::string, std::string, std::string>, Cells> groups;
    std::map<std::pair<std::string, std::string>, Cells> all;
    for (const ReportCell& cell : data.from_files) {
        // A failed cell counts: its verdicts are what failed.
        if (cell.status == "unavailable") continue;
        groups[{cell.scene, cell.algorithm, cell.precision}].push_back(&cell);
        all[{cell.algorithm, cell.precision}].push_back(&cell);
    }
    for (const auto& [key, cells] : all)
        grid.rows.push_back(robustness_row_of({"all scenes", key.first, key.second}, cells));
    for (const auto& [key, cells] : groups) {
        const auto& [scene, algorithm, precision] = key;
        grid.rows.push_back(robustness_row_of({scene, algorithm, precision}, cells));
    }
    return grid;
}

}  // namespace edgewise::reports
