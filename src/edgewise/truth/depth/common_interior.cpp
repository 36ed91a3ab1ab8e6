// SPDX-License-Identifier: MIT
//
// Cutting planes over the cone of normals n with n.w >= 0 for all points w seen so far. A normal from the
// middle of the cone is tried on all vertices; a point below it is a new cut. Ends with a normal that
// separates, or with an empty cone. Finite: every cut is a vertex pair not seen before. No tolerance.
#include "edgewise/truth/depth/common_interior.hpp"

#include <algorithm>
#include <vector>

namespace edgewise::truth {

namespace {

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
        return std::all_of(points_.begin(), points_.end(),
                           [&](const IntegerVec& p) { return sgn(dot(ray, p)) >= 0; });
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

}  // namespace

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

}  // namespace edgewise::truth
