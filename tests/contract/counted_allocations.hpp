// SPDX-License-Identifier: MIT
//
// Counts the heap allocations of this program by operator new, while a counter is active.
#pragma once

#include <cstddef>

namespace edgewise {

/// Counts from construction to destruction; one at a time.
class CountedAllocations {
  public:
    CountedAllocations();
    ~CountedAllocations();
    CountedAllocations(const CountedAllocations&) = delete;
    CountedAllocations& operator=(const CountedAllocations&) = delete;

    /// Allocations so far, freed ones included.
    [[nodiscard]] std::size_t count() const;

    /// Bytes allocated since the start and not freed.
    [[nodiscard]] std::size_t live_bytes() const;
};

}  // namespace edgewise
