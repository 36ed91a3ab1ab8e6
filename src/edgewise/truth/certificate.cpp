// SPDX-License-Identifier: MIT
//
// Doubles are whole numbers times powers of two, so directions and vertices are integers here; the bounds are
// roots of quotients, rounded outward.
#include "edgewise/truth/certificate.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "edgewise/truth/dyadic.hpp"
#include "edgewise/truth/exact_distance.hpp"

namespace edgewise::truth {

namespace {

/// The vertices of a claim that the body has; vertex 0 if it has none of them.
std::vector<std::uint32_t> vertices_of(std::span<const std::uint32_t> claim, std::size_t vertex_count) {
    std::vector<std::uint32_t> result;
    for (const std::uint32_t i : claim)
        if (i < vertex_count) result.push_back(i);
    if (result.empty()) result.push_back(0);
    return result;
}

/// Returns the separation of the bodies along a direction, either way; 0 if they are not separated.
double gap_along(ExactPair& bodies, const IntegerVec& direction) {
    if (direction.is_zero()) return 0;
    const mpz_class gap = std::max(bodies.lowest(direction).height, bodies.lowest(-direction).height);
    if (sgn(gap) <= 0) return 0;
    return root_rounded_down(gap * gap, dot(direction, direction), bodies.unit);
}

std::vector<Vec3d> chosen(std::span<const Vec3d> vertices, std::span<const std::uint32_t> indices) {
    std::vector<Vec3d> result;
    for (const std::uint32_t i : indices) result.push_back(vertices[i]);
    return result;
}

/// The line from one body to the other that exact_distance found between some of their vertices.
SubsetTrial<IntegerVec> line_between(ExactPair& bodies, const SimplexSeed& simplex,
                                     std::span<const std::uint32_t> on_a,
                                     std::span<const std::uint32_t> on_b) {
    MinimumSimplex<IntegerVec> found;
    found.size = simplex.size;
    for (int i = 0; i < simplex.size; ++i) {
        const VertexPair pair = simplex.pair[i];
        found.point[i] = bodies.difference({on_a[pair.a], on_b[pair.b]});
    }
    SubsetTrial<IntegerVec> line = subset_of<IntegerVec>(found, ~0U, nullptr);
    if (!find_direction(line))
        throw std::logic_error("certificate: a simplex of exact_distance has no nearest point");
    line.point = {};  // these pointers must not outlive `found`
    return line;
}

}  // namespace

Result<Certificate> certify(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                            const Pose& pose_b, std::span<const std::uint32_t> on_a,
                            std::span<const std::uint32_t> on_b, const Vec3d& direction) {
    if (std::string error = pair_error(a, pose_a, b, pose_b); !error.empty()) {
        return Result<Certificate>::failure(std::move(error));
    }
    ExactPair bodies(a, pose_a, b, pose_b);
    const auto some_of_a = vertices_of(on_a, a.size()), some_of_b = vertices_of(on_b, b.size());
    Certificate result;
    if (direction.allFinite()) result.lower = gap_along(bodies, scaled(direction, least_exponent(direction)));
    const auto best = exact_distance(chosen(a, some_of_a), pose_a, chosen(b, some_of_b), pose_b);
    const auto line = line_between(bodies, best->simplex, some_of_a, some_of_b);
    result.upper = 0;
    if (sgn(line.height) == 0) return Result<Certificate>::success(result);
    result.upper =
        root_rounded_up(line.height * line.height, dot(line.direction, line.direction), bodies.unit);
    result.lower = std::max(result.lower, gap_along(bodies, line.direction));
    return Result<Certificate>::success(result);
}

Certificate widen(const Certificate& stored, double error_a, double error_b) {
    if (error_a == 0 && error_b == 0) return stored;
    const double infinity = std::numeric_limits<double>::infinity();
    if (!(error_a >= 0 && error_b >= 0)) return {};
    const double error = std::nextafter(error_a + error_b, infinity);
    return {std::max(0.0, std::nextafter(stored.lower - error, -infinity)),
            std::nextafter(stored.upper + error, infinity)};
}

double representation_error(std::span<const Vec3d> given, std::span<const Vec3d> stored,
                            const Mat3d& rotation) {
    assert(given.size() == stored.size());
    const Pose pose{rotation, Vec3d::Zero()};
    if (!pair_error(given, pose, stored, pose).empty()) return std::numeric_limits<double>::infinity();
    ExactPair bodies(given, pose, stored, pose);
    mpz_class largest;
    for (std::uint32_t i = 0; i < given.size(); ++i) {
        const IntegerVec moved = bodies.difference({i, i});
        largest = std::max(largest, dot(moved, moved));
    }
    return root_rounded_up(largest, 1, bodies.unit);
}

}  // namespace edgewise::truth
