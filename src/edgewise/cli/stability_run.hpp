// SPDX-License-Identifier: MIT
//
// A stability run into a store, with progress on stderr: for the command of that name and for the sweep.
#pragma once

#include <functional>

#include "edgewise/studies/stability.hpp"

namespace edgewise::cli {

/// Ctrl-C stops after the row in hand. `on_row` may be empty.
studies::StabilitySummary store_stability(const studies::StabilityPlan& plan, store::Store& store,
                                          const std::function<void(const studies::StabilityRow&)>& on_row);

}  // namespace edgewise::cli
