// SPDX-License-Identifier: MIT
//
// Misses against size, for fully associative LRU caches of every size at once: a histogram of stack
// distances.
#pragma once

#include <cstdint>
#include <vector>

namespace edgewise::measure {

class MissCurve {
  public:
    /// A use after this many other lines.
    void add(std::uint64_t distance) {
        if (distance >= at_.size()) at_.resize(2 * distance + 1, 0);
        ++at_[distance];
        ++uses_;
    }
    /// The first use of a line: a miss in every size.
    void add_first() {
        ++firsts_;
        ++uses_;
    }

    [[nodiscard]] std::uint64_t uses() const { return uses_; }
    [[nodiscard]] std::uint64_t firsts() const { return firsts_; }

    /// Uses that a cache of so many lines misses, first uses included.
    [[nodiscard]] std::uint64_t misses(std::uint64_t lines) const;

    /// The smallest size whose misses, without first uses, are at most so many; 0: even none would do.
    [[nodiscard]] std::uint64_t smallest_size(double misses) const;

    /// Sizes at which the misses change, growing, and the misses from there on; at most `points` of them,
    /// evenly spread over the logarithm of size.
    struct Point {
        std::uint64_t lines, misses;
    };
    [[nodiscard]] std::vector<Point> points(std::size_t points) const;

  private:
    std::vector<std::uint64_t> at_;  ///< uses by distance
    std::uint64_t uses_ = 0, firsts_ = 0;
};

/// The knee of a scene: the smallest cache in which a query finds nine tenths of what it comes back to, that
/// is, in which it brings in again, on average, at most a tenth of the lines it touches. Below it the scene
/// thrashes: lines are evicted before they are used again. `touched`: distinct lines that all queries
/// touched, summed over queries.
[[nodiscard]] inline std::uint64_t knee(const MissCurve& curve, std::uint64_t touched) {
    return curve.smallest_size(0.1 * static_cast<double>(touched));
}

}  // namespace edgewise::measure
