// SPDX-License-Identifier: MIT
//
// Distance: weights by Cramer's rule with a common denominator, so that everything stays in integers. Depth:
// the inner point is the mean c of the first four points of the polytope. To stay in integers the surface is
// seen from there, four times as large: 4 p - 4 c.
#include "edgewise/truth/exact_proof.hpp"

#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "edgewise/geometry/message.hpp"
#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::truth {

namespace {

void require(bool holds, const char* otherwise, const char* of = "depth") {
    if (!holds) throw std::logic_error(std::string("exact ") + of + ": " + otherwise);
}

/// The weights of the nearest point, up to a common positive factor. Written out per size, not shared with
/// the search.
std::array<mpz_class, 4> simplex_weights(const MinimumSimplex<IntegerVec>& s) {
    const std::array<IntegerVec, 4>& p = s.point;
    if (s.size == 1) return {mpz_class(1), 0, 0, 0};
    if (s.size == 2) {
        const IntegerVec edge = p[1] - p[0];
        return {dot(p[1], edge), -dot(p[0], edge), 0, 0};
    }
    if (s.size == 3) {
        const IntegerVec normal = cross(p[1] - p[0], p[2] - p[0]);
        return {dot(normal, cross(p[1], p[2])), dot(normal, cross(p[2], p[0])),
                dot(normal, cross(p[0], p[1])), 0};
    }
    std::array<mpz_class, 4> w = {dot(p[1], cross(p[2], p[3])), -dot(p[0], cross(p[2], p[3])),
                                  dot(p[0], cross(p[1], p[3])), -dot(p[0], cross(p[1], p[2]))};
    if (sgn(w[0]) < 0) {
        for (mpz_class& weight : w) weight = -weight;
    }
    return w;
}

/// Returns true if the weights give total * (nearest point), where nearest point = (h / u.u) u.
bool is_weighted_mean(const MinimumSimplex<IntegerVec>& s) {
    const std::array<mpz_class, 4> weights = simplex_weights(s);
    mpz_class total;
    IntegerVec sum;
    for (int i = 0; i < s.size; ++i) {
        if (sgn(weights[i]) < 0) return false;
        total += weights[i];
        sum += weights[i] * s.point[i];
    }
    if (sgn(total) <= 0) return false;
    if (s.holds_origin()) return sum.is_zero();
    const mpz_class along = total * s.height;
    return dot(s.direction, s.direction) * sum == along * s.direction;
}

}  // namespace

void require_optimal(ExactPair& bodies, const MinimumSimplex<IntegerVec>& simplex) {
    for (int i = 0; i < simplex.size; ++i) {
        require(simplex.point[i] == bodies.difference(simplex.pair[i]),
                "a simplex point is not the difference of its vertices", "distance");
    }
    require(is_weighted_mean(simplex), "the nearest point is not in the hull of its simplex", "distance");
    if (simplex.holds_origin()) return;
    require(bodies.lowest(simplex.direction).height >= simplex.height,
            "a vertex pair lies below the nearest point", "distance");
}

namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Checks every vertex of both bodies, without the filter that the search relies on.
void require_supporting(ExactPair& bodies, const IntegerVec& normal, const mpz_class& height) {
    const auto highest = [](ExactBody& body, const IntegerVec& direction) {
        mpz_class most = dot(direction, body.world(0));
        for (std::uint32_t i = 1; i < body.size(); ++i) {
            most = std::max(most, dot(direction, body.world(i)));
        }
        return most;
    };
    require(highest(bodies.a, normal) + highest(bodies.b, -normal) == height,
            "the plane does not bound A - B");
}

class Surface {
  public:
    explicit Surface(const ExpandingPolytope& polytope) {
        IntegerVec centre;
        for (int i = 0; i < 4; ++i) centre += polytope.points()[i].point;
        for (const DifferencePoint& p : polytope.points()) points_.push_back(4 * p.point - centre);
        for (const ExpandingPolytope::Face& f : polytope.faces()) {
            if (!f.removed) faces_.push_back(f.corner);
        }
        for (const Corners& c : faces_) {
            for (int i = 0; i < 3; ++i) {
                const bool fresh = apex_.emplace(std::pair(c[i], c[(i + 1) % 3]), c[(i + 2) % 3]).second;
                require(fresh, "two faces lie on the same side of an edge");
            }
        }
    }

    void require_convex() const {
        for (const Corners& c : faces_) {
            const IntegerVec& p = points_[c[0]];
            const IntegerVec normal = cross(points_[c[1]] - p, points_[c[2]] - p);
            const mpz_class height = dot(normal, p);
            require(sgn(height) > 0, "the inner point is not below a face");
            for (int i = 0; i < 3; ++i) {
                const auto beyond = apex_.find(std::pair(c[(i + 1) % 3], c[i]));
                require(beyond != apex_.end(), "the polytope is not closed");
                require(dot(normal, points_[beyond->second]) <= height, "the polytope has a dent");
            }
        }
        for (std::size_t i = 1; i < faces_.size(); ++i) {
            require(!ray_meets(faces_[i]), "the polytope covers itself twice");
        }
    }

  private:
    /// The ray from the inner point through the middle of the first face.
    [[nodiscard]] bool ray_meets(const Corners& c) const {
        IntegerVec ray = points_[faces_[0][0]];
        ray += points_[faces_[0][1]];
        ray += points_[faces_[0][2]];
        for (int i = 0; i < 3; ++i) {
            const IntegerVec side = cross(points_[c[i]], points_[c[(i + 1) % 3]]);
            if (sgn(dot(side, ray)) < 0) return false;
        }
        return true;
    }

    std::vector<IntegerVec> points_;
    std::vector<Corners> faces_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>
        apex_;  ///< by the directed edge before it
};

/// Planes are computed again from the corners: those that the search keeps are not trusted.
void require_nearest(const ExpandingPolytope& polytope, const IntegerVec& normal, const mpz_class& height) {
    const mpz_class squared_height = height * height;
    const mpz_class squared_normal = dot(normal, normal);
    for (const ExpandingPolytope::Face& f : polytope.faces()) {
        if (f.removed) continue;
        const IntegerVec& p = polytope.points()[f.corner[0]].point;
        const IntegerVec n =
            cross(polytope.points()[f.corner[1]].point - p, polytope.points()[f.corner[2]].point - p);
        const mpz_class h = dot(n, p);
        require(sgn(h) >= 0, "the origin is outside of the polytope");
        require(h * h * squared_normal >= squared_height * dot(n, n), "a face is nearer");
    }
}

}  // namespace

void require_depth(ExactPair& bodies, const ExpandingPolytope& polytope, std::uint32_t face) {
    for (const DifferencePoint& p : polytope.points()) {
        require(p.point == bodies.difference(p.pair), "a point is not the difference of its vertices");
    }
    const ExpandingPolytope::Face& f = polytope.faces()[face];
    require(sgn(f.squared_normal) > 0, "a face without a normal");
    require_supporting(bodies, f.normal, f.height);
    require_nearest(polytope, f.normal, f.height);
    Surface(polytope).require_convex();
}

// The simplex of exact_distance, which holds the origin, is filled up to a tetrahedron and then expanded.
// Each step takes in a vertex pair not seen before, so the loop ends. The origin may lie on the surface: a
// face at distance 0 is expanded like any other.

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
    require(is_deep == (verdict == ExactVerdict::overlapping), "the verdict says otherwise");
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
