// SPDX-License-Identifier: MIT
//
// What a load takes here that is answered by each level: loads that depend on each other, over memory that
// the level holds and the one above does not.
#pragma once

#include <vector>

#include "edgewise/measure/cache/cache_machine.hpp"

namespace edgewise::studies::advise {

/// ns beyond a load that the first level answers: of each further level of the machine, then of memory; some
/// milliseconds each, of memory up to a second. Zero at least.
[[nodiscard]] std::vector<double> latencies_beyond_first(const measure::CacheMachine& host);

}  // namespace edgewise::studies::advise
