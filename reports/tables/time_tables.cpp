// SPDX-License-Identifier: MIT
//
// The time tables: medians with their intervals, and the ratio to the baseline cell timed in the same rounds.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/ratio_interval.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::reports {

namespace {

GridCell range_cell(const measure::Figure& low, const measure::Figure& high) {
    if (!low.value) return figure_cell(low);
    if (!high.value) return figure_cell(high);
    return {fmt::format("{} to {}", number_text(*low.value, low.unit), number_text(*high.value, high.unit))};
}

GridCell ratio_interval_cell(const ReportCell& cell, PairKind kind) {
    std::vector<double> ratios;
    const measure::PerQuery per_query =
        kind == PairKind::Separated ? &measure::Timing::separated : &measure::Timing::overlapping;
    for (const measure::Round& round : cell.rounds)
        if (const auto ratio = round.ratio(per_query)) ratios.push_back(*ratio);
    const auto interval = median_interval(std::move(ratios));
    if (!interval) return missing_cell("fewer than two rounds with such pairs in cell and baseline");
    return {fmt::format("{:.3f} to {:.3f}{}", interval->low, interval->high,
                        interval->whole_range ? " (range)" : "")};
}

std::vector<GridCell> time_row(const ReportCell& cell, PairKind kind) {
    const store::QueryTime& times = times_of(kind);
    const measure::Figure ratio = cell.figure(times.ratio);
    return grid_row(cell.shape, cell.vertices, cell.algorithm, cell.table, cell.figure(times.ns),
                    range_cell(cell.figure(times.low), cell.figure(times.high)), figure_cell(ratio, 1, 3),
                    ratio.value ? ratio_interval_cell(cell, kind) : figure_cell(ratio),
                    cell.figure("time.rounds"));
}

/// Unmeasured cells go last.
double rank(const ReportCell& cell, PairKind kind) {
    return cell.figure(times_of(kind).ns).value.value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

TextGrid time_grid(const ReportData& data, const std::string& scene_label, PairKind kind,
                   const std::string& shape) {
    TextGrid grid{
        fmt::format("{}, {} pairs{}, fastest first", scene_label, pair_name(kind),
                    shape.empty() ? ": by shape" : ", " + shape),
        columns_of("shape|#vertices|algorithm|table type|#ns per query|#95 % interval|#ratio to baseline|"
                   "#95 % interval|#rounds")};
    std::vector<std::pair<double, const ReportCell*>> cells;
    for (const ReportCell* cell : verified_cells(data, shape, scene_label))
        cells.emplace_back(rank(*cell, kind), cell);
    std::stable_sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
        return std::tie(a.second->vertices, a.second->shape, a.first) <
               std::tie(b.second->vertices, b.second->shape, b.first);
    });
    for (const auto& [ns, cell] : cells) grid.rows.push_back(time_row(*cell, kind));
    return grid;
}

}  // namespace edgewise::reports
