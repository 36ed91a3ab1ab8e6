// SPDX-License-Identifier: MIT
//
// What the tables of a cell take of memory, and of time to build.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace edgewise::measure {

struct MemoryUse {
    std::uint64_t tables = 0;
    double requested = 0;            ///< bytes asked of the allocator: the sum of the tables
    double taken = 0;                ///< bytes that these take there: headers, size classes, gaps
    std::optional<double> resident;  ///< bytes of pages in memory; nothing where the allocator cannot tell
    double materialised = 1;         ///< part of the tables' bytes that ever stood; below 1 in lazy tables
};

struct BuildTimes {
    std::vector<double> build_ns;  ///< a table of the body, from scratch
    std::vector<double> refit_ns;  ///< the same table, in place, for the body deformed; empty: it cannot
};

}  // namespace edgewise::measure
