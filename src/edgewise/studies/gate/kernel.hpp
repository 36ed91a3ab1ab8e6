// SPDX-License-Identifier: MIT
//
// Measures the speed of this machine independently of algorithms and layouts, about half of the time each: a
// chain of dependent multiplications, limited by the clock, and a walk along pointers through a
// buffer larger than a first-level and smaller than a second-level cache, limited by the caches.
#pragma once

#include <cstdint>
#include <vector>

namespace edgewise::studies {

class GateKernel {
  public:
    GateKernel();

    /// Time of one run in ns, with the buffer in cache.
    [[nodiscard]] double time_ns() const;

  private:
    /// One node per cache line.
    struct alignas(64) Node {
        const Node* next = nullptr;
    };

    [[nodiscard]] const Node* walk(const Node* from, int steps) const;

    std::vector<Node> nodes_;
};

}  // namespace edgewise::studies
