// SPDX-License-Identifier: MIT
//
// Edgewise beside other libraries: time beside error, of one scene and shape, fastest first. Ratios are of
// the same rounds, so that they do not move with the machine's clock.
#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <map>
#include <string_view>

#include "edgewise/measure/statistics.hpp"
#include "edgewise/reports/tables/formatting.hpp"
#include "edgewise/reports/tables/ratio_interval.hpp"
#include "edgewise/reports/tables/tables.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::reports {

namespace {

double separated_ns(const ReportCell& cell) {
    return cell.figure(store::separated_time.ns).value.value_or(std::numeric_limits<double>::infinity());
}

/// Pairs in a row that are asked together: the same question, so beside the plain cells.
constexpr std::string_view batched = "batch=yes";

/// The cells of a scene and shape that ask for the whole answer, ours and theirs, fastest first.
std::vector<const ReportCell*> side_by_side(const ReportData& data, const std::string& scene_label,
                                            const std::string& shape) {
    std::vector<const ReportCell*> cells;
    for (const auto* from : {&data.cells, &data.from_files, &data.peers}) {
        for (const ReportCell& cell : *from) {
            if (cell.scene_label == scene_label && cell.shape == shape && cell.is_timed() &&
                (cell.axes.empty() || cell.axes == batched))
                cells.push_back(&cell);
        }
    }
    std::stable_sort(cells.begin(), cells.end(), [](const ReportCell* a, const ReportCell* b) {
        return separated_ns(*a) < separated_ns(*b);
    });
    return cells;
}

/// The fastest of other libraries that gives distances; none: null.
const ReportCell* best_peer(const std::vector<const ReportCell*>& fastest_first) {
    for (const ReportCell* cell : fastest_first) {
        if (cell->judged() && cell->figure("error.worst_error_stored").value) return cell;
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
    if (!peer) return missing_cell("no other library was measured beside it");
    std::vector<double> ratios = round_ratios(cell, *peer);
    const auto middle = measure::median(ratios);
    const auto interval = median_interval(std::move(ratios));
    if (!middle || !interval) return missing_cell("fewer than two rounds with separated pairs in both");
    return {fmt::format("{:.2f} ({:.2f} to {:.2f})", *middle, interval->low, interval->high)};
}

std::vector<GridCell> row_of(const ReportCell& cell, const ReportCell* peer) {
    return grid_row(cell.shape, cell.vertices, cell.judged() ? cell.layout : cell.algorithm,
                    cell.judged() ? cell.precision : cell.table, cell.figure(store::separated_time.ns),
                    ratio_to_peer(cell, peer), cell.figure("error.worst_error_stored"),
                    cell.figure("error.p99_error_stored"), cell.figure("error.wrong_verdicts"),
                    cell.figure("error.checked"), cell.figure("bytes.table_bytes"),
                    cell.figure("bytes.object_bytes"), cell.figure("bytes.pair_bytes"));
}

}  // namespace

bool has_peers(const ReportData& data) { return !data.peers.empty(); }

TextGrid peers_grid(const ReportData& data) {
    TextGrid grid{"Other libraries", columns_of("adapter|library, query, cache and flags")};
    for (const auto& [key, value] : data.meta) {
        constexpr std::string_view prefix = store::peer_key;
        if (key.starts_with(prefix)) grid.add(key.substr(prefix.size()), value);
    }
    return grid;
}

TextGrid peer_grid(const ReportData& data, const std::string& scene_label) {
    TextGrid grid{fmt::format("{}, separated pairs: by shape, fastest first", scene_label),
                  columns_of("shape|#vertices|algorithm or library|table type or precision|#ns per query|"
                             "#ratio to the fastest peer|#worst error|#p99 error|#wrong verdicts|"
                             "#checked|#bytes of a table|#of its object|#of a pair")};
    std::vector<std::pair<std::int64_t, std::string>> shapes;
    for (const ReportCell& cell : data.peers) shapes.emplace_back(cell.vertices, cell.shape);
    std::sort(shapes.begin(), shapes.end());
    shapes.erase(std::unique(shapes.begin(), shapes.end()), shapes.end());
    for (const auto& [vertices, shape] : shapes) {
        const std::vector<const ReportCell*> cells = side_by_side(data, scene_label, shape);
        if (std::none_of(cells.begin(), cells.end(), [](const ReportCell* cell) { return cell->judged(); }))
            continue;
        const ReportCell* peer = best_peer(cells);
        for (const ReportCell* cell : cells) grid.rows.push_back(row_of(*cell, peer));
    }
    return grid;
}

}  // namespace edgewise::reports
