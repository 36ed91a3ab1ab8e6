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

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "edgewise/measure/cache/trace.hpp"

namespace edgewise::measure {

/// Misses against size, for caches of every size at once: a histogram of stack distances.
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

    /// Uses that a cache of this number of lines misses, first uses included.
    [[nodiscard]] std::uint64_t misses(std::uint64_t lines) const;

    /// Smallest size that has at most this number of misses, first uses excluded; 0 if even no cache has.
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

    /// Miss curve of all uses so far, for caches of every size.
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

/// Reuse of the tables' pages alone: the pages that a memory of any size has to fetch again, if it evicts the
/// least recently used page.
class PageReuse final : public TraceListener {
  public:
    explicit PageReuse(std::uint64_t page_bytes) : page_bytes_(page_bytes) {}

    void on_query_start(QueryStart start) override { start_ = start; }
    void on_access(const TracedAccess& access) override {
        if (access.side == TraceSide::scene) return;
        access.for_each_unit(page_bytes_, [this](std::uint64_t page) {
            const std::uint64_t distance = reuse_.use(page);
            curves_.each(start_, [&](MissCurve& curve) {
                distance == ReuseDistance::never ? curve.add_first() : curve.add(distance);
            });
        });
    }
    void on_query_end(bool /*counts*/) override {
        queries_.add(start_, 1);
        start_.reset();
    }

    /// Starts counting: earlier uses stay known but are not counted.
    void start_counting() {
        queries_ = {};
        curves_ = {};
    }

    /// Distinct pages so far.
    [[nodiscard]] std::uint64_t pages() const { return reuse_.lines(); }
    /// Fetches per query in a memory of this number of pages, of all queries and by their start; no value if
    /// no query has that start.
    [[nodiscard]] ByStart<std::optional<double>> fetches_per_query(std::uint64_t memory_pages) const {
        const auto mean = [&](const MissCurve& curve, std::uint64_t queries) -> std::optional<double> {
            if (queries == 0) return std::nullopt;
            return static_cast<double>(curve.misses(memory_pages)) / static_cast<double>(queries);
        };
        return {mean(curves_.all, queries_.all), mean(curves_.cold, queries_.cold),
                mean(curves_.warm, queries_.warm)};
    }

  private:
    std::uint64_t page_bytes_;
    ReuseDistance reuse_;
    ByStart<MissCurve> curves_;
    ByStart<std::uint64_t> queries_;
    std::optional<QueryStart> start_;
};

}  // namespace edgewise::measure
