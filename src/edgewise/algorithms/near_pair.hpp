// SPDX-License-Identifier: MIT
//
// A pair for the question if its bodies are nearer than some margin: its bounds (distance_bounds.hpp) answer
// where they can, else a query, which renews them.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/distance_bounds.hpp"
#include "edgewise/algorithms/observer.hpp"
#include "edgewise/algorithms/penetration/start.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/aabb.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// Largest distance of the body from its origin.
template <SupportTable Table>
[[nodiscard]] double radius_of(const Table& table) {
    double radius = 0;
    for (const auto v : table.all_vertices()) {
        const Vec3d point = cast<double>(table.vertex(v));
        radius = std::max(radius, radius_of(std::span(&point, 1)));
    }
    return radius;
}

/// Bounds from an answer to a query at this pose. They rely only on its normal and witness points: no vertex
/// of either body lies between the two planes across the normal, and the witness points are points of the
/// bodies. Both hold to the rounding of the tables' arithmetic, and the bounds include it. `pair` as the
/// query left it: the farthest vertices along the normal are at its end, or next to it.
template <SupportTable TableA, SupportTable TableB, class Pair>
[[nodiscard]] DistanceInterval proven_interval(const TableA& a, const TableB& b,
                                               const Transform<double>& a_from_b, const Distance& answer,
                                               double size, const Pair& pair) {
    using Scalar = ComputeOf<TableA>;
    const double noise = 2 * double{Tolerance<Scalar>::level} * size;
    if (answer.status != Status::separated) return {0, noise};
    const Transform<Scalar> transform = cast<Scalar>(a_from_b);
    const Vec3<Scalar> normal = cast<Scalar>(answer.normal);
    const auto& ended = simplex_of(a, b, pair);
    const bool is_kept = ended.count() > 0;
    const auto from_a = is_kept ? ended.corner(0).a : a.first_vertex();
    const auto from_b = is_kept ? ended.corner(0).b : b.first_vertex();
    const auto on_a = support(a, normal, from_a);
    const auto on_b = support(b, Vec3<Scalar>(-transform.direction_back(normal)), from_b);
    const Scalar gap = dot(normal, Vec3<Scalar>(transform.point(on_b.point) - on_a.point));
    const double most = norm(Vec3d(answer.point_b - answer.point_a)) + noise;
    return {std::clamp(static_cast<double>(gap) - noise, 0.0, most), most};
}

/// State of a pair between such questions. The bounds first: most questions read only them.
template <class Pair>
struct NearCache {
    DistanceBounds bounds;
    Pair pair;
};

/// Queries the tables for the whole distance, and renews the bounds from the answer; a query that fails
/// leaves them as they are.
template <class Algorithm, SupportTable TableA, SupportTable TableB, class Pair, class Observer = NoObserver>
Distance ask_near(const TableA& a, const TableB& b, const Transform<double>& a_from_b, const Radii& radii,
                  NearCache<Pair>& cache, const QueryOptions& options = {}, Observer&& observer = {}) {
    assert(options.contact_tolerance == 0 && std::isinf(options.cutoff));
    const Distance answer = Algorithm::query(a, b, a_from_b, cache.pair, options, observer);
    if (answer.status == Status::failed) [[unlikely]]
        return answer;
    const double size = std::max(radii.a, radii.b + norm(a_from_b.translation));
    cache.bounds = {proven_interval(a, b, a_from_b, answer, size, cache.pair), a_from_b, radii.b};
    return answer;
}

/// Borrows both tables, which must outlive it and be neither rebuilt nor refitted; temporary tables do not
/// compile.
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
        if (const auto known = cache_.bounds.nearer_than(distance, a_from_b))
            return *known || !is_answerable(a_, b_, a_from_b);
        const Distance answer = ask(a_from_b);
        return answer.status == Status::failed || answer.distance < distance;
    }

    /// Returns the whole answer if the bodies are nearer to each other than `distance`, and nothing if they
    /// are not, mostly without reading a table: at_least() is then a proven lower bound. To rounding, and a
    /// pose that cannot be answered counts as nearer, as in nearer_than().
    [[nodiscard]] std::optional<Distance> answer_within(double distance, const Transform<double>& a_from_b) {
        const auto known = cache_.bounds.nearer_than(distance, a_from_b);
        if (known && !*known && is_answerable(a_, b_, a_from_b)) return std::nullopt;
        const Distance answer = ask(a_from_b);
        return answer.status == Status::failed || answer.distance < distance ? std::optional(answer)
                                                                             : std::nullopt;
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
