// SPDX-License-Identifier: MIT
//
// A measure of this machine's mood that no change of algorithms or layouts touches: a chain of dependent
// multiplications, which goes as the clock goes, and a walk along pointers through a buffer larger than a
// first-level cache and smaller than a second, which goes as caches go. About half of its time each.
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
    /// One to a cache line.
    struct alignas(64) Node {
        const Node* next = nullptr;
    };

    [[nodiscard]] const Node* walk(const Node* from, int steps) const;

    std::vector<Node> nodes_;
};

}  // namespace edgewise::studies
