// SPDX-License-Identifier: MIT
#include "edgewise/algorithms/sweep_and_prune.hpp"

#include <algorithm>
#include <numeric>

namespace edgewise {

SweepAndPrune::SweepAndPrune(std::size_t body_count) {
    for (std::vector<std::uint32_t>& order : order_) {
        order.resize(body_count);
        std::iota(order.begin(), order.end(), 0U);
    }
}

void SweepAndPrune::sort_pairs() { std::sort(pairs_.begin(), pairs_.end()); }

}  // namespace edgewise
