// SPDX-License-Identifier: MIT
//
// A chart of curves over one number of a scene: one curve per algorithm and table type, with its interval
// behind it. Colour is the layout, dash what else makes the table type (precision, further axes), point shape
// the algorithm. Its layers are the part "curves" of shared.vl.json: the interval layer comes first and holds
// the layout's parameter, since a composite error bar in its place would swallow legend clicks without a
// word.
#pragma once

#include "edgewise/reports/charts/charts.hpp"

namespace edgewise::reports {

/// What names a cell among curves: cell_json, and `variant`, `point`, `stroke`. A row that sets `unjoined`
/// is a point that no line goes through; one that sets `larger` is a larger one.
[[nodiscard]] ChartJson curve_json(const ReportCell& cell);
/// A row with the time of all pairs and its interval in `ns`, `low`, `high`; null, and counted, when it was
/// not measured.
[[nodiscard]] ChartJson timed_row(const ReportCell& cell, Omissions& omitted);

/// Adds such a row for each cell for which `place` gives more members: where it stands; null: nowhere.
template <class Place>
void add_timed_rows(ChartRows& rows, const std::vector<const ReportCell*>& cells, const Place& place) {
    for (const ReportCell* cell : cells) {
        const ChartJson more = place(*cell);
        if (more.is_null()) continue;
        ChartJson row = timed_row(*cell, rows.omitted);
        if (row.is_null()) continue;
        row.update(more);
        rows.values.push_back(std::move(row));
    }
}

}  // namespace edgewise::reports
