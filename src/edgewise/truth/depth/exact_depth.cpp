// SPDX-License-Identifier: MIT
//
// The simplex of exact_distance, which holds the origin, is filled up to a tetrahedron and then expanded.
// Each step takes in a vertex pair not seen before, so the loop ends. The origin may lie on the surface: a
// face at distance 0 is expanded like any other.
#include "edgewise/truth/depth/exact_depth.hpp"

#include <optional>
#include <stdexcept>

#include "edgewise/geometry/message.hpp"
#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "edgewise/truth/exact_proof.hpp"

namespace edgewise::truth {

namespace {

/// A normal of a plane through up to three independent points.
IntegerVec normal_of(const std::vector<DifferencePoint>& points) {
    if (points.size() == 1) return {1, 0, 0};
    const IntegerVec edge = points[1].point - points[0].point;
    return points.size() == 3 ? cross(edge, points[2].point - points[0].point) : perpendicular_to(edge);
}

/// Adds points until there are four that span space; or gives the normal of a plane that holds all of A - B.
std::optional<IntegerVec> span_space(ExactPair& bodies, std::vector<DifferencePoint>& points) {
    while (points.size() < 4) {
        IntegerVec normal = normal_of(points);
        const mpz_class height = dot(normal, points[0].point);
        LowestPoint lowest = bodies.lowest(normal);
        if (lowest.height == height) {
            lowest = bodies.lowest(-normal);
            if (lowest.height == -height) return normal;
        }
        points.push_back({lowest.pair, std::move(lowest.point)});
    }
    return std::nullopt;
}

/// Expands until the nearest face bounds A - B.
std::uint32_t expand(ExactPair& bodies, ExpandingPolytope& polytope) {
    for (;;) {
        const std::uint32_t face = polytope.nearest();
        LowestPoint beyond = bodies.lowest(-polytope.faces()[face].normal);
        if (beyond.height == -polytope.faces()[face].height) return face;
        polytope.expand(face, {beyond.pair, std::move(beyond.point)});
    }
}

Vec3d rounded_unit(const IntegerVec& normal) {
    const mpz_class square = dot(normal, normal);
    const auto entry = [&](const mpz_class& x) { return sgn(x) * rounded_root(x * x, square, 0); };
    return {entry(normal.x), entry(normal.y), entry(normal.z)};
}

/// Compares the depth with the verdict of exact_distance, which is found in another way.
void require_agreement(bool is_deep, ExactVerdict verdict) {
    if (is_deep != (verdict == ExactVerdict::overlapping)) {
        throw std::logic_error("exact depth: the verdict says otherwise");
    }
}

ExactDepth measure(ExactPair& bodies, const SimplexSeed& simplex, ExactVerdict verdict) {
    std::vector<DifferencePoint> points;
    for (int i = 0; i < simplex.size; ++i) {
        points.push_back({simplex.pair[i], bodies.difference(simplex.pair[i])});
    }
    if (const auto flat = span_space(bodies, points)) {
        require_agreement(false, verdict);
        return {0, rounded_unit(*flat)};
    }
    ExpandingPolytope polytope(std::move(points));
    const std::uint32_t nearest = expand(bodies, polytope);
    require_depth(bodies, polytope, nearest);
    const ExpandingPolytope::Face& face = polytope.faces()[nearest];
    require_agreement(sgn(face.height) > 0, verdict);
    return {rounded_root(face.squared_height, face.squared_normal, bodies.unit), rounded_unit(face.normal)};
}

}  // namespace

Result<ExactDepth> exact_depth(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                               const Pose& pose_b, const SimplexSeed& seed) {
    const Result<ExactDistance> contact = exact_distance(a, pose_a, b, pose_b, seed);
    if (!contact) return Result<ExactDepth>::failure(contact.error);
    if (contact->verdict == ExactVerdict::separated) {
        return Result<ExactDepth>::failure(
            message("the bodies are ", contact->distance, " apart; ask for the depth of bodies in contact"));
    }
    ExactPair bodies(a, pose_a, b, pose_b);
    return Result<ExactDepth>::success(measure(bodies, contact->simplex, contact->verdict));
}

}  // namespace edgewise::truth
