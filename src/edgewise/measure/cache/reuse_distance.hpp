// SPDX-License-Identifier: MIT
//
// Exact stack distances in one pass: how many other lines were used since a line was used last. A fully
// associative LRU cache of more lines than that still has it, a smaller one has not (Mattson, Gecsei, Slutz,
// Traiger, "Evaluation techniques for storage hierarchies", 1970); so one pass gives the misses of every
// size.
//
// Each line's last use is a bit on a time line; the distance is the number of bits after it (Bennett and
// Kruskal, "LRU stack processing", 1975; Olken, 1981). The bits of 64 uses are a word, and a Fenwick tree
// (Fenwick, 1994) sums words. When the time line is full, bits move together and time goes on behind them.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "edgewise/measure/cache/miss_curve.hpp"

namespace edgewise::measure {

class ReuseDistance {
  public:
    static constexpr std::uint64_t never = ~std::uint64_t{0};

    /// The distance of this use, `never` for the first of the line, and one more use of the curve. Line
    /// numbers should be small: memory is used up to the largest.
    std::uint64_t use(std::uint64_t line) {
        if (line == last_line_) [[likely]] {
            curve_.add(0);
            return 0;
        }
        return use_another(line);
    }

    /// Distinct lines so far.
    [[nodiscard]] std::uint64_t lines() const { return live_; }

    /// What all uses so far say of caches of every size.
    [[nodiscard]] const MissCurve& curve() const { return curve_; }

    /// The uses so far are no part of the curve; where lines were last used stays known.
    void forget_curve() { curve_ = {}; }

  private:
    std::uint64_t use_another(std::uint64_t line);
    void compact();
    void set(std::uint64_t time);
    void clear(std::uint64_t time);
    /// Bits at `time` or before.
    [[nodiscard]] std::uint64_t count_to(std::uint64_t time) const;

    std::uint64_t last_line_ = never;
    std::vector<std::uint64_t> last_use_;  ///< by line: time + 1; 0: not yet
    std::vector<std::uint64_t> words_;     ///< a bit per time: some line's last use
    std::vector<std::uint64_t> tree_;      ///< Fenwick tree over the words' bit counts, from 1
    std::uint64_t now_ = 0, live_ = 0;
    MissCurve curve_;
};

}  // namespace edgewise::measure
