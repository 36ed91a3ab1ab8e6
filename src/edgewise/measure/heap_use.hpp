// SPDX-License-Identifier: MIT
//
// What a cell's structures take of a heap of size classes, each in an arena of its own: requested (counted by
// whoever asked), the size classes that these became, and the pages behind them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace edgewise::measure {

struct HeapStructure {
    std::string name;
    std::uint64_t requested = 0, size_classes = 0;
    std::uint64_t resident = 0;  ///< pages in memory, the arena's own books included
};

struct HeapUse {
    std::vector<HeapStructure> structures;
    std::string reason, remedy;  ///< why there are none
};

}  // namespace edgewise::measure
