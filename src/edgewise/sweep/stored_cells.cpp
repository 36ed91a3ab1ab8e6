// SPDX-License-Identifier: MIT
#include "edgewise/sweep/stored_cells.hpp"

#include <algorithm>

#include "edgewise/store/vocabulary.hpp"

namespace edgewise::sweep {

std::optional<std::string> StoredCells::status_of(const CellRun& cell) const {
    const auto row = store_.find_cell(build_, cell.row().hash);
    if (!row) return std::nullopt;
    if (row->status == "verified" && (!rounds_missing(cell).empty() || lacks_caches(cell)))
        return std::nullopt;
    return row->status;
}

bool StoredCells::lacks_caches(const CellRun& cell) const {
    if (cell.caches().machines.empty()) return false;
    constexpr store::FigureName identity("caches.identity");
    const double wanted = cell.caches().identity();
    const std::vector<store::FigureRow> stored = store_.figures(build_, cell.row().hash);
    return std::none_of(stored.begin(), stored.end(), [&](const store::FigureRow& row) {
        return row.probe == identity.probe() && row.name == identity.name() && row.value == wanted;
    });
}

std::vector<int> StoredCells::rounds_missing(const CellRun& cell) const {
    const auto done = store_.rounds_done(build_, cell.row().hash);
    std::vector<int> missing;
    for (int round = 0; round < rounds_; ++round) {
        if (!done.contains(round)) missing.push_back(round);
    }
    return missing;
}

}  // namespace edgewise::sweep
