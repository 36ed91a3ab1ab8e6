// SPDX-License-Identifier: MIT
//
// GJK on integers. Each step adds the lowest point along the direction to the simplex, and the distance
// shrinks strictly, so no simplex comes twice and the loop ends.
#include "edgewise/truth/exact_distance.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/exact_proof.hpp"

namespace edgewise::truth {

namespace {

/// Takes the guess as it is if its weights are all positive.
bool adopt(ExactPair& bodies, const SimplexSeed& seed, MinimumSimplex<IntegerVec>& simplex) {
    for (int i = 0; i < seed.size; ++i) simplex.point[i] = bodies.difference(seed.pair[i]);
    simplex.pair = seed.pair;
    simplex.size = seed.size;
    SubsetTrial<IntegerVec> trial = subset_of<IntegerVec>(simplex, ~0U, nullptr);
    if (!find_direction(trial)) return false;
    simplex.direction = std::move(trial.direction);
    simplex.height = std::move(trial.height);
    return true;
}

/// Returns true if the point is now part of the simplex; false if it does not lie below it.
bool descend(MinimumSimplex<IntegerVec>& simplex, IntegerVec point, VertexPair pair) {
    // Once the origin is held nothing is nearer, and the normal of a triangle around it points to no side.
    if (simplex.size > 0 && simplex.holds_origin()) return false;
    if (simplex.size > 0 && dot(simplex.direction, point) >= simplex.height) return false;
    if (!add_point(simplex, std::move(point), pair)) {
        throw std::logic_error("exact distance: no part of a simplex holds its nearest point");
    }
    return true;
}

MinimumSimplex<IntegerVec> starting_simplex(ExactPair& bodies, const SimplexSeed& seed) {
    MinimumSimplex<IntegerVec> simplex;
    if (adopt(bodies, seed, simplex)) return simplex;
    simplex = {};
    for (int i = 0; i < seed.size; ++i) descend(simplex, bodies.difference(seed.pair[i]), seed.pair[i]);
    return simplex;
}

MinimumSimplex<IntegerVec> minimise(ExactPair& bodies, const SimplexSeed& seed) {
    MinimumSimplex<IntegerVec> simplex = starting_simplex(bodies, seed_simplex(bodies, seed));
    while (!simplex.holds_origin()) {
        LowestPoint lowest = bodies.lowest(simplex.direction);
        if (!descend(simplex, std::move(lowest.point), lowest.pair)) break;
    }
    return simplex;
}

/// The normals n with n.w >= 0 for all points w of A - B seen so far. No tolerance.
class NormalCone {
  public:
    /// Needs points that span space: then the cone has no line in it and is the hull of its extreme rays.
    explicit NormalCone(const std::vector<IntegerVec>& points) {
        for (const IntegerVec& p : points) cut(p);
    }

    /// Narrows the cone to n.point >= 0. An extreme ray of the new cone is an old one, or is perpendicular to
    /// the new point and to one of the others.
    void cut(const IntegerVec& point) {
        std::erase_if(rays_, [&](const IntegerVec& ray) { return sgn(dot(ray, point)) < 0; });
        points_.push_back(point);
        for (const IntegerVec& other : points_) {
            IntegerVec ray = cross(point, other);
            if (ray.is_zero()) continue;
            if (admits(ray)) rays_.push_back(ray);
            ray = -ray;
            if (admits(ray)) rays_.push_back(std::move(ray));
        }
    }

    [[nodiscard]] bool empty() const { return rays_.empty(); }

    /// A sum of rays of a cone without lines is never zero.
    [[nodiscard]] IntegerVec middle() const {
        IntegerVec sum;
        for (const IntegerVec& ray : rays_) sum += ray;
        return sum;
    }

  private:
    [[nodiscard]] bool admits(const IntegerVec& ray) const {
        return std::ranges::all_of(points_, [&](const IntegerVec& p) { return sgn(dot(ray, p)) >= 0; });
    }

    std::vector<IntegerVec> points_;
    std::vector<IntegerVec> rays_;
};

/// A normal perpendicular to up to two independent vectors.
IntegerVec normal_to(const std::vector<IntegerVec>& basis) {
    if (basis.empty()) return {1, 0, 0};
    return basis.size() == 2 ? cross(basis[0], basis[1]) : perpendicular_to(basis[0]);
}

/// Adds points of A - B on both sides of the normal's plane; returns false if one side has none.
bool straddles(ExactPair& bodies, const IntegerVec& normal, std::vector<IntegerVec>& points) {
    LowestPoint below = bodies.lowest(normal);
    if (sgn(below.height) >= 0) return false;
    LowestPoint above = bodies.lowest(-normal);
    if (sgn(above.height) >= 0) return false;
    points.push_back(std::move(above.point));
    points.push_back(std::move(below.point));
    return true;
}

/// Grows the points until they span space; false if a separating plane turns up on the way.
bool span_space(ExactPair& bodies, std::vector<IntegerVec>& points) {
    std::vector<IntegerVec> basis;
    if (!points.empty()) basis.push_back(points.front());
    while (basis.size() < 3) {
        if (!straddles(bodies, normal_to(basis), points)) return false;
        basis.push_back(points.back());
    }
    return true;
}

/// Returns true if A - B has the origin, which the simplex holds, in its interior. A flat body that pierces a
/// solid overlaps it, because no small motion separates the two; a flat A - B (coplanar polygons, segments)
/// overlaps nothing. A normal from the middle of the cone is tried on all vertices, and a point below it is a
/// new cut, a pair of vertices not seen before: this ends with a normal that separates or with an empty cone.
bool has_common_interior(ExactPair& bodies, const MinimumSimplex<IntegerVec>& simplex) {
    if (simplex.size == 4) return true;
    std::vector<IntegerVec> points;
    // A separating normal is perpendicular to the triangle that has the origin inside: two choices, one
    // plane.
    if (simplex.size == 3) return straddles(bodies, simplex.direction, points);
    // An edge through the origin: both ends bound the normals. A point at the origin bounds nothing.
    if (simplex.size == 2) points = {simplex.point[0], simplex.point[1]};
    if (!span_space(bodies, points)) return false;
    NormalCone cone(points);
    while (!cone.empty()) {
        const LowestPoint lowest = bodies.lowest(cone.middle());
        if (sgn(lowest.height) >= 0) return false;
        cone.cut(lowest.point);
    }
    return true;
}

ExactDistance separated_answer(const MinimumSimplex<IntegerVec>& simplex, long unit) {
    ExactDistance answer;
    const mpz_class& height = simplex.height;
    const mpz_class square = dot(simplex.direction, simplex.direction);
    answer.distance = rounded_root(height * height, square, unit);
    answer.separation = {rounded_quotient(height * simplex.direction.x, square, unit),
                         rounded_quotient(height * simplex.direction.y, square, unit),
                         rounded_quotient(height * simplex.direction.z, square, unit)};
    return answer;
}

}  // namespace

Result<ExactDistance> exact_distance(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                                     const Pose& pose_b, const SimplexSeed& seed) {
    std::string error = pair_error(a, pose_a, b, pose_b);
    if (!error.empty()) return Result<ExactDistance>::failure(std::move(error));
    ExactPair bodies(a, pose_a, b, pose_b);
    const MinimumSimplex<IntegerVec> simplex = minimise(bodies, seed);
    require_optimal(bodies, simplex);
    ExactDistance answer;
    if (!simplex.holds_origin()) {
        answer = separated_answer(simplex, bodies.unit);
    } else {
        const bool interior = has_common_interior(bodies, simplex);
        answer.verdict = interior ? ExactVerdict::overlapping : ExactVerdict::touching;
    }
    answer.simplex.pair = simplex.pair;
    answer.simplex.size = simplex.size;
    return Result<ExactDistance>::success(std::move(answer));
}

}  // namespace edgewise::truth
