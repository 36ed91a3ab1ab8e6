// SPDX-License-Identifier: MIT
//
// A pair that is asked whether it is nearer than some margin: by its bounds where these tell, else by a
// query, which renews them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "edgewise/algorithms/distance_bounds.hpp"

namespace edgewise {

/// Of two tables that outlive it and are not rebuilt.
template <class Algorithm, SupportTable TableA, SupportTable TableB>
class NearPair {
  public:
    NearPair(const TableA& a, const TableB& b)
        : a_(a), b_(b), pair_(a, b), radius_a_(radius_of(a)), radius_b_(radius_of(b)) {}

    /// Whether the bodies are nearer to each other than `distance`. To rounding: bodies at just this distance
    /// may be called either.
    [[nodiscard]] bool nearer_than(double distance, const Transform<double>& a_from_b) {
        if (const auto known = bounds_.nearer_than(distance, a_from_b)) return *known;
        return ask(a_from_b).distance < distance;
    }

    /// The distance is no less, and no more, than this; no table is read.
    [[nodiscard]] DistanceInterval bounds(const Transform<double>& a_from_b) const {
        return bounds_.at(a_from_b);
    }

    /// Asks the tables, and with the answer renews the bounds.
    Distance ask(const Transform<double>& a_from_b) {
        ++queries_;
        const Distance answer = Algorithm::query(a_, b_, a_from_b, pair_);
        const double size = std::max(radius_a_, radius_b_ + norm(a_from_b.translation));
        bounds_ = {proven_interval(a_, b_, a_from_b, answer, size), a_from_b, radius_b_};
        return answer;
    }

    /// How often the tables were asked.
    [[nodiscard]] std::uint64_t queries() const { return queries_; }

  private:
    const TableA& a_;
    const TableB& b_;
    typename Algorithm::template Pair<TableA, TableB> pair_;
    DistanceBounds bounds_;
    double radius_a_, radius_b_;
    std::uint64_t queries_ = 0;
};

}  // namespace edgewise
