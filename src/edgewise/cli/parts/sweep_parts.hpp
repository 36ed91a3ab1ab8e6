// SPDX-License-Identifier: MIT
//
// A plan's parts in turn, under one progress bar: the sweep, then the studies.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>

#include "edgewise/store/store.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::cli {

struct StudyCounts {
    std::size_t rows = 0, failed = 0, unavailable = 0;
};

struct PartsSummary {
    sweep::SweepSummary sweep;
    std::map<std::string, StudyCounts> studies;  ///< by name; none of a study without rows
    bool stopped = false;                        ///< before the end of the last part

    [[nodiscard]] StudyCounts all_studies() const;
};

/// Ctrl-C stops after the piece in hand; what is stored stays. on_cells: called with the number of cells more
/// that are there.
[[nodiscard]] PartsSummary run_parts(const sweep::SweepWork& work, store::Store& store,
                                     const std::function<void(std::size_t cells)>& on_cells);

}  // namespace edgewise::cli
