// SPDX-License-Identifier: MIT
//
// The paging run of a plan: hundreds of bodies with tables of their own under memory limits (paging.hpp), as
// rows of the store under the scene `paging`. Limits are parts of what the tables touch, from an eighth to
// more than all.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "edgewise/store/store.hpp"

namespace edgewise::studies {

/// Parameters of the paging run.
struct PagingPlan {
    std::size_t bodies = 600;
    double rotation_step = 7.0 / 60;  ///< rad: the end of the paper's axis at 60 steps per second
    std::size_t steps = 6;            ///< of a pass
    std::uint64_t seed = 1;
};

/// Runs the paper's cell, V-Clip on its own layout, and GJK, a lean layout and a smaller body, as far as this
/// program has them. Rows already stored for the build are kept. Calls `on_row` for each row. Returns false
/// if it was stopped before the last.
[[nodiscard]] bool run_paging(const PagingPlan& plan, const std::string& build, store::Store& store,
                              const std::function<void(const store::CellRow&)>& on_row,
                              const std::atomic<bool>& stop);

/// Returns how many rows the paging run has.
[[nodiscard]] std::size_t paging_rows();

}  // namespace edgewise::studies
