// SPDX-License-Identifier: MIT
//
// Tables of times: medians with their intervals and the ratio to the baseline cell timed in the same rounds;
// and Edgewise next to other libraries, with errors. Ratios are of the same rounds, so the clock does not
// move them.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

/// The largest k with P(B < k) <= 2.5 %; 0 when there is none.
std::size_t trimmed_each_side(std::size_t n) {
    // 2^-n underflows past 1074; beyond 1000 rounds the k of 1000 gives an interval wider than need be, never
    // narrower.
    const std::size_t count = std::min<std::size_t>(n, 1000);
    double term = std::ldexp(1.0, -static_cast<int>(count)), below = 0;
    for (std::size_t k = 0; k < count; ++k) {
        below += term;
        if (below > 0.025) return k;
        term *= static_cast<double>(count - k) / static_cast<double>(k + 1);
    }
    return 0;
}

}  // namespace

/// The k-th smallest and k-th largest of n values enclose the median with probability 1 - 2 P(B < k), B
/// binomial(n, 1/2) (David and Nagaraja, Order Statistics, 7.1).
std::optional<RatioInterval> median_interval(std::vector<double> ratios) {
    if (ratios.size() < 2) return std::nullopt;
    std::ranges::sort(ratios);
    const std::size_t k = trimmed_each_side(ratios.size());
    if (k == 0) return RatioInterval{ratios.front(), ratios.back(), true};
    return RatioInterval{ratios[k - 1], ratios[ratios.size() - k], false};
}

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

}  // namespace

TextGrid time_grid(const ReportData& data, const std::string& scene_label, PairKind kind) {
    TextGrid grid{
        fmt::format("{}, {} pairs: by shape, fastest first", scene_label, pair_name(kind)),
        columns_of("shape|#vertices|algorithm|table type|#ns per query|#95 % interval|#ratio to baseline|"
                   "#95 % interval|#rounds")};
    std::vector<std::pair<double, const ReportCell*>> cells;
    for (const ReportCell* cell : verified_cells(data, {}, scene_label))
        cells.emplace_back(or_infinity(*cell, times_of(kind).ns), cell);
    std::ranges::stable_sort(cells, {}, [](const auto& one) {
        return std::tie(one.second->vertices, one.second->shape, one.first);
    });
    for (const auto& [ns, cell] : cells) grid.rows.push_back(time_row(*cell, kind));
    return grid;
}

namespace {

constexpr std::string_view verdict_alone = "needs=verdict";

/// Pairs in a row that are asked together are asked for the whole answer, as in the plain cells.
bool asks(const ReportCell& cell, bool verdict) {
    return verdict ? cell.axes == verdict_alone : cell.axes.empty() || cell.axes == "batch=yes";
}

/// The cells of a scene and shape that ask for the whole answer, or for the verdict alone, ours and theirs,
/// fastest first.
std::vector<const ReportCell*> side_by_side(const ReportData& data, const std::string& scene_label,
                                            const std::string& shape, bool verdict) {
    std::vector<const ReportCell*> cells = cells_in({&data.cells, &data.from_files, &data.peers});
    std::erase_if(cells, [&](const ReportCell* cell) {
        return cell->scene_label != scene_label || cell->shape != shape || !cell->is_timed() ||
               !asks(*cell, verdict);
    });
    std::ranges::stable_sort(
        cells, {}, [](const ReportCell* cell) { return or_infinity(*cell, store::separated_time.ns); });
    return cells;
}

/// The fastest of other libraries, for distances only of libraries that give them; null if there is none.
const ReportCell* best_peer(const std::vector<const ReportCell*>& fastest_first) {
    for (const ReportCell* cell : fastest_first) {
        if (cell->judged() && (asks(*cell, true) || cell->figure("error.worst_error_stored").value))
            return cell;
    }
    return nullptr;
}

/// Ratios of the rounds that both have.
std::vector<double> round_ratios(const ReportCell& cell, const ReportCell& to) {
    std::map<int, double> theirs;
    for (const measure::Round& round : to.rounds)
        if (const auto ns = round.timing.separated()) theirs[round.number] = *ns;
    std::vector<double> ratios;
    for (const measure::Round& round : cell.rounds) {
        const auto ns = round.timing.separated();
        if (const auto known = theirs.find(round.number); ns && known != theirs.end())
            ratios.push_back(*ns / known->second);
    }
    return ratios;
}

/// "0.42 (0.41 to 0.44)"
GridCell ratio_to_peer(const ReportCell& cell, const ReportCell* peer) {
    if (!peer) return missing_cell("no other library was measured in the same rounds");
    std::vector<double> ratios = round_ratios(cell, *peer);
    const auto middle = measure::median(ratios);
    const auto interval = median_interval(std::move(ratios));
    if (!middle || !interval) return missing_cell("fewer than two rounds with separated pairs in both");
    return {fmt::format("{:.2f} ({:.2f} to {:.2f})", *middle, interval->low, interval->high)};
}

std::vector<GridCell> row_of(const ReportCell& cell, const ReportCell* peer) {
    return grid_row(cell.shape, cell.vertices, cell.judged() ? cell.layout : cell.algorithm,
                    cell.judged() ? cell.precision + (asks(cell, true) ? " needs=verdict" : "") : cell.table,
                    cell.figure(store::separated_time.ns), ratio_to_peer(cell, peer),
                    cell.figure("error.worst_error_stored"), cell.figure("error.p99_error_stored"),
                    cell.figure("error.wrong_verdicts"), cell.figure("error.checked"),
                    cell.figure("bytes.table_bytes"), cell.figure("bytes.object_bytes"),
                    cell.figure("bytes.pair_bytes"));
}

}  // namespace

TextGrid peers_grid(const ReportData& data) {
    TextGrid grid{"Other libraries", columns_of("adapter|library, query, cache and flags")};
    for (const auto& [adapter, library] : data.meta_with(store::peer_key)) grid.add(adapter, library);
    return grid;
}

TextGrid peer_grid(const ReportData& data, const std::string& scene_label) {
    TextGrid grid{fmt::format("{}, separated pairs: by shape, fastest first", scene_label),
                  columns_of("shape|#vertices|algorithm or library|table type or precision|#ns per query|"
                             "#ratio to the fastest peer|#worst error|#p99 error|#wrong verdicts|"
                             "#checked|#bytes of a table|#of its object|#of a pair")};
    std::set<std::pair<std::int64_t, std::string>> shapes;
    for (const ReportCell& cell : data.peers) shapes.emplace(cell.vertices, cell.shape);
    for (const auto& [vertices, shape] : shapes) {
        for (const bool verdict : {false, true}) {
            const std::vector<const ReportCell*> cells = side_by_side(data, scene_label, shape, verdict);
            if (std::ranges::none_of(cells, [](const ReportCell* cell) { return cell->judged(); })) continue;
            const ReportCell* peer = best_peer(cells);
            for (const ReportCell* cell : cells) grid.rows.push_back(row_of(*cell, peer));
        }
    }
    return grid;
}

// Effort of queries of Edgewise and of other libraries, as the effort run counted it. Rows are ordered by
// instructions, fewest first, and compared with the least that a proof needs.

namespace {

constexpr const char* names = "scene|shape|algorithm or library|table type or precision";

/// Rows that were measured at all, by scene and shape; those that were not counted go last.
std::vector<const ReportCell*> in_order(const ReportData& data) {
    std::vector<const ReportCell*> rows = cells_in({&data.effort});
    std::erase_if(rows, [](const ReportCell* row) { return !row->is_timed(); });
    std::ranges::stable_sort(rows, [](const ReportCell* a, const ReportCell* b) {
        return std::tuple(a->scene_label, a->vertices, a->shape, or_infinity(*a, "effort.instructions")) <
               std::tuple(b->scene_label, b->vertices, b->shape, or_infinity(*b, "effort.instructions"));
    });
    return rows;
}

/// Names of the machines with simulated caches, in order.
std::set<std::string> machines_of(const ReportData& data) {
    constexpr store::FigureName misses("effort.{machine}.d1_misses");
    std::set<std::string> machines;
    for (const ReportCell& row : data.effort)
        for (const store::FigureRow& figure : row.figures)
            if (auto machine = misses.value_in(figure.probe, figure.name))
                machines.insert(std::move(*machine));
    return machines;
}

/// `machines` must outlive the columns.
std::vector<FigureColumn> spent_columns(const std::set<std::string>& machines) {
    constexpr store::FigureName d1("effort.{machine}.d1_misses"), ll("effort.{machine}.ll_misses");
    std::vector<FigureColumn> columns = {{"instructions", "effort.instructions"},
                                         {"mispredictions, modelled", "effort.mispredictions"}};
    for (const std::string& machine : machines) {
        columns.push_back({"D1 misses, " + machine, d1.of(machine)});
        columns.push_back({"LL misses", ll.of(machine)});
    }
    const FigureColumn rest[] = {{"bytes of a table", "bytes.table_bytes"},
                                 {"of its object", "bytes.object_bytes"},
                                 {"of a pair", "bytes.pair_bytes"},
                                 {"steps", "effort.steps"},
                                 {"vertices read", "effort.vertices_read"},
                                 {"lines read", "effort.lines_read"},
                                 {"instructions per step", "effort.instructions_per_step"},
                                 {"mispredictions per step", "effort.mispredictions_per_step"},
                                 {"vertices per step", "effort.vertices_per_step"}};
    columns.insert(columns.end(), std::begin(rest), std::end(rest));
    return columns;
}

}  // namespace

TextGrid effort_grid(const ReportData& data) {
    const std::set<std::string> machines = machines_of(data);
    return cell_grid("Per query of all queries, fewest instructions first", names, spent_columns(machines),
                     in_order(data));
}

TextGrid effort_floor_grid(const ReportData& data) {
    const FigureColumn columns[] = {{"flops of the floor", "effort.floor_flops"},
                                    {"its vertices", "effort.floor_vertices"},
                                    {"its lines", "effort.floor_lines"},
                                    {"instructions per flop of it", "effort.instructions_over_floor"},
                                    {"vertices read over its own", "effort.vertices_over_floor"},
                                    {"lines read over its own", "effort.lines_over_floor"}};
    return cell_grid("The floor: a proof of the known answer by heights of vertices", names, columns,
                     in_order(data));
}

}  // namespace edgewise::reports
