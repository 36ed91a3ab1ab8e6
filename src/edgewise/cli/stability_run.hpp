// SPDX-License-Identifier: MIT
//
// A stability run into a store, with progress on stderr: for the command of that name and for the sweep.
#pragma once

#include <functional>

#include "edgewise/studies/stability.hpp"
#include "edgewise/sweep/plan.hpp"

namespace edgewise::cli {

/// Ctrl-C stops after the row in hand. `on_row` may be empty.
studies::StabilitySummary store_stability(const studies::StabilityPlan& plan, store::Store& store,
                                          std::size_t rows,
                                          const std::function<void(const studies::StabilityRow&)>& on_row);

/// The bodies of a plan's mesh files; what cannot be read is passed over with a line on stderr.
[[nodiscard]] std::vector<Polyhedron> real_bodies(const sweep::Plan& plan);

}  // namespace edgewise::cli
