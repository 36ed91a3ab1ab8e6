// SPDX-License-Identifier: MIT
//
// A plan's parts in turn, under one progress bar: the sweep, then the hard families, paging, what could have
// made the paper's figure 8, and what the queries take.
#pragma once

#include <cstddef>
#include <functional>

#include "edgewise/store/store.hpp"
#include "edgewise/studies/stability.hpp"
#include "edgewise/sweep/run.hpp"

namespace edgewise::cli {

struct PartsSummary {
    sweep::SweepSummary sweep;
    studies::StabilitySummary stability;
    bool stopped = false;  ///< before the end of the last part
};

/// Ctrl-C stops after the piece in hand; what is stored stays. on_cells: called with the number of cells more
/// that are there.
[[nodiscard]] PartsSummary run_parts(const sweep::SweepWork& work, store::Store& store,
                                     const std::function<void(std::size_t cells)>& on_cells);

}  // namespace edgewise::cli
