// SPDX-License-Identifier: MIT
//
// What caches a sweep wants modelled of a cell: on which machines, over how many queries.
#pragma once

#include <cstddef>
#include <span>

#include "edgewise/measure/cache/machine_choice.hpp"

namespace edgewise::bench {

struct CacheOrder {
    std::span<const measure::MachineChoice> machines = {};  ///< empty: no caches are modelled
    std::size_t queries = 0;                                ///< traced, of those that count; 0: all

    /// A number that is another one for other machines or another number of queries; whole, and exact as a
    /// figure.
    [[nodiscard]] double identity() const;
};

}  // namespace edgewise::bench
