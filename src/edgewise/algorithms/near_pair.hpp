// SPDX-License-Identifier: MIT
//
// A pair for the question if its bodies are nearer than some margin: its bounds answer where they can, else a
// query, which renews them.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/distance_bounds.hpp"
#include "edgewise/algorithms/observer.hpp"
#include "edgewise/algorithms/query_options.hpp"

namespace edgewise {

/// State of a pair between such questions. The bounds first: most questions read only them.
template <class Pair>
struct NearCache {
    DistanceBounds bounds;
    Pair pair;
};

/// Queries the tables for the whole distance, and renews the bounds from the answer.
template <class Algorithm, SupportTable TableA, SupportTable TableB, class Pair, class Observer = NoObserver>
Distance ask_near(const TableA& a, const TableB& b, const Transform<double>& a_from_b, const Radii& radii,
                  NearCache<Pair>& cache, const QueryOptions& options = {}, Observer&& observer = {}) {
    assert(options.contact_tolerance == 0 && !options.verdict_only);
    const Distance answer = Algorithm::query(a, b, a_from_b, cache.pair, options, observer);
    const double size = std::max(radii.a, radii.b + norm(a_from_b.translation));
    cache.bounds = {proven_interval(a, b, a_from_b, answer, size, cache.pair), a_from_b, radii.b};
    return answer;
}

/// Borrows both tables, which must outlive it and must not be rebuilt; temporary tables do not compile.
template <class Algorithm, SupportTable TableA, SupportTable TableB>
class NearPair {
  public:
    NearPair(const TableA& a, const TableB& b)
        : a_(a), b_(b), cache_{{}, {a, b}}, radii_{radius_of(a), radius_of(b)} {}
    NearPair(const TableA&&, const TableB&) = delete;
    NearPair(const TableA&, const TableB&&) = delete;
    NearPair(const TableA&&, const TableB&&) = delete;

    /// Returns true if the bodies are nearer to each other than `distance`. To rounding: at exactly this
    /// distance either answer is possible. A pose that cannot be answered (answerable.hpp) counts as nearer,
    /// since the caller then computes the distance, and that query fails.
    [[nodiscard]] bool nearer_than(double distance, const Transform<double>& a_from_b) {
        if (!is_answerable(a_, b_, a_from_b)) [[unlikely]]
            return true;
        if (const auto known = cache_.bounds.nearer_than(distance, a_from_b)) return *known;
        return ask(a_from_b).distance < distance;
    }

    /// Lower and upper bound of the distance; no table is read. Nothing is known at a pose that cannot be
    /// answered.
    [[nodiscard]] DistanceInterval bounds(const Transform<double>& a_from_b) const {
        if (!is_answerable(a_, b_, a_from_b)) return {};
        return cache_.bounds.at(a_from_b);
    }
    [[nodiscard]] double at_least(const Transform<double>& a_from_b) const { return bounds(a_from_b).least; }

    Distance ask(const Transform<double>& a_from_b) {
        ++queries_;
        return ask_near<Algorithm>(a_, b_, a_from_b, radii_, cache_);
    }

    /// Number of queries to the tables.
    [[nodiscard]] std::uint64_t queries() const { return queries_; }

  private:
    const TableA& a_;
    const TableB& b_;
    NearCache<typename Algorithm::template Pair<TableA, TableB>> cache_;
    Radii radii_;
    std::uint64_t queries_ = 0;
};

}  // namespace edgewise
