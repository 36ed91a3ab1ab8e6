// SPDX-License-Identifier: MIT
//
// `edgewise bench effort --by-phase`: instructions, modelled mispredictions and misses per query and per
// step, divided by the phases of the algorithm, and what runs once a query apart from what each step takes.
#pragma once

#include "edgewise/studies/phases/effort_phases.hpp"

namespace edgewise::cli {

/// Prints the plan's table types, and gives the exit code: a check failed where an answer is wrong or phases
/// do not add up to what Callgrind counted.
[[nodiscard]] int print_phases(const studies::EffortPlan& plan, bool json);

}  // namespace edgewise::cli
