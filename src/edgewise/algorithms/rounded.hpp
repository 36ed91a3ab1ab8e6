// SPDX-License-Identifier: MIT
//
// Rounded bodies: all points within a radius of a core, which is any body with a table. A sphere is a point
// with a radius, a capsule a segment, an engine's hull with a margin a hull. Queries ask the cores: the
// difference of two rounded bodies is that of their cores, enlarged by the sum of the radii on all sides, so
// distances and depths differ by that sum, along the same normal.
#pragma once

#include <algorithm>
#include <cassert>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/observer.hpp"
#include "edgewise/algorithms/penetration.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise {

/// The table must live longer. Radius: not negative, in the body's unit.
template <SupportTable Table>
struct Rounded {
    const Table& core;
    double radius = 0;
};

/// Makes the answer of cores that of rounded bodies. Of bodies that overlap, as of cores that do, the points
/// are void and the normal is zero.
inline void add_radii(double radius_a, double radius_b, double contact_tolerance, Distance& answer) {
    assert(radius_a >= 0 && radius_b >= 0);
    if (answer.status == Status::failed) return;
    const double gap = answer.distance - (radius_a + radius_b);
    answer.point_a += radius_a * answer.normal;
    answer.point_b -= radius_b * answer.normal;
    answer.distance = std::max(gap, 0.0);
    if (gap < 0) {
        answer.status = Status::overlapping;
        answer.normal = Vec3d::Zero();
    } else if (answer.status == Status::separated && gap <= contact_tolerance) {
        answer.status = Status::touching;
    }
}

/// Distance of two rounded bodies, as Algorithm::query of their cores (Gjk, or VClip). `a_from_b` takes B's
/// points into A's frame; `pair` is that of the cores. For the verdict alone (QueryOptions) GJK ends as soon
/// as a direction separates the rounded bodies. `observer`: as Algorithm::query's.
template <class Algorithm, SupportTable TableA, SupportTable TableB, class Observer = NoObserver>
[[nodiscard]] Distance query_rounded(const Rounded<TableA>& a, const Rounded<TableB>& b,
                                     const Transform<double>& a_from_b,
                                     typename Algorithm::template Pair<TableA, TableB>& pair,
                                     const QueryOptions& options = {}, Observer&& observer = {}) {
    QueryOptions of_cores = options;
    const double radii = a.radius + b.radius;
    of_cores.contact_tolerance = options.is_for_verdict() ? options.contact_tolerance + radii : 0;
    of_cores.cutoff = options.cutoff + radii;
    Distance answer = Algorithm::query(a.core, b.core, a_from_b, pair, of_cores, observer);
    add_radii(a.radius, b.radius, options.contact_tolerance, answer);
    return answer;
}

/// Depth of two rounded bodies that touch or overlap, from the answer of their cores. Cores with a distance
/// know it; the depth of others is asked for, from the pair that the query left.
template <SupportTable TableA, SupportTable TableB>
[[nodiscard]] Penetration rounded_penetration(const Rounded<TableA>& a, const Rounded<TableB>& b,
                                              const Transform<double>& a_from_b, const Distance& cores,
                                              const SimplexPair<TableA, TableB>& start,
                                              PenetrationSpace& space) {
    Penetration found{.depth = -cores.distance,
                      .normal = cores.normal,
                      .point_a = cores.point_a,
                      .point_b = cores.point_b,
                      .converged = true};
    if (!(cores.distance > 0)) found = penetration(a.core, b.core, a_from_b, start, space);
    found.depth += a.radius + b.radius;
    found.point_a += a.radius * found.normal;
    found.point_b -= b.radius * found.normal;
    return found;
}

}  // namespace edgewise
