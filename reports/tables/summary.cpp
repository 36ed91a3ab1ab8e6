// SPDX-License-Identifier: MIT
#include "edgewise/reports/tables/summary.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace edgewise::reports {

GridCell summary_cell(const std::vector<const ReportCell*>& rows, const SummaryColumn& column) {
    measure::Figure total{column.figure.name(), std::nullopt, ""};
    std::size_t missing = 0;
    for (const ReportCell* cell : rows) {
        const measure::Figure figure = cell->figure(column.figure);
        if (!figure.value) {
            ++missing;
            if (!total.value) total.reason = figure.reason, total.remedy = figure.remedy;
            continue;
        }
        const double so_far = total.value.value_or(*figure.value);
        const bool first = !total.value;
        total.value = column.sum && !first ? so_far + *figure.value : std::max(so_far, *figure.value);
        total.unit = figure.unit;
    }
    GridCell shown = figure_cell(total);
    if (total.value && missing) shown.text += fmt::format(" ({} of {})", rows.size() - missing, rows.size());
    return shown;
}

}  // namespace edgewise::reports
