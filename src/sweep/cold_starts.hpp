// SPDX-License-Identifier: MIT
//
// Which queries of a warm scene are the first of their pair: cold by nature, and left out of what is said of
// warm ones.
#pragma once

#include <cstdint>
#include <vector>

#include "edgewise/scene/workload.hpp"

namespace edgewise {

/// One flag a query; all zero where every query is cold.
[[nodiscard]] inline std::vector<std::uint8_t> cold_starts(const Workload& workload) {
    std::vector<std::uint8_t> cold(workload.queries.size(), 0), met(workload.pair_count, 0);
    for (std::size_t i = 0; workload.warm && i < cold.size(); ++i) {
        std::uint8_t& known = met[workload.queries[i].pair];
        cold[i] = !known;
        known = 1;
    }
    return cold;
}

}  // namespace edgewise
