// SPDX-License-Identifier: MIT
//
// The timed, interleaved rounds of cells that share their queries.
#pragma once

#include <atomic>
#include <span>

#include "edgewise/sweep/plan.hpp"
#include "edgewise/sweep/stored_cells.hpp"

namespace edgewise::sweep {

/// Every round that a verified cell is missing: each such cell once, in an order of its own each round, the
/// baseline somewhere among them. A round is stored when it is done, and `stop` looked at before the next.
void time_rounds(const Plan& plan, std::span<const CellRun> cells, const CellRun& baseline,
                 StoredCells& stored, const std::atomic<bool>& stop);

}  // namespace edgewise::sweep
