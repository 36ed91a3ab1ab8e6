// SPDX-License-Identifier: MIT
//
// Doubles are whole numbers times powers of two, so weights, directions and vertices are integers here; the
// bounds are roots of quotients, rounded outward.
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

/// The vertices of a witness that the body has, with their weights as integers.
struct Mean {
    std::vector<std::uint32_t> vertices;
    std::vector<mpz_class> weights;
    mpz_class total;
    bool is_weighted = false;
};

Mean mean_of(const WitnessClaim& witness, std::size_t vertex_count) {
    assert(witness.weights.empty() || witness.weights.size() == witness.vertices.size());
    Mean mean;
    std::vector<double> weights;
    for (std::size_t i = 0; i < witness.vertices.size(); ++i) {
        const double weight = witness.weights.empty() ? 1 : witness.weights[i];
        if (witness.vertices[i] >= vertex_count || !(std::isfinite(weight) && weight > 0)) continue;
        mean.vertices.push_back(witness.vertices[i]);
        weights.push_back(weight);
    }
    mean.is_weighted = !witness.weights.empty();
    if (mean.vertices.empty()) {
        mean.vertices = {0};
        weights = {1};
    }
    // In units of the smallest power of two among them.
    const long unit = least_exponent(weights);
    for (const double w : weights) {
        mean.weights.push_back(scaled(w, unit));
        mean.total += mean.weights.back();
    }
    return mean;
}

/// The sum of weight times position: total times the point.
IntegerVec weighted_sum(ExactBody& body, const Mean& mean) {
    IntegerVec sum;
    for (std::size_t i = 0; i < mean.vertices.size(); ++i) {
        sum += mean.weights[i] * body.world(mean.vertices[i]);
    }
    return sum;
}

double distance_of_means(ExactPair& bodies, const Mean& on_a, const Mean& on_b) {
    const mpz_class totals = on_a.total * on_b.total;
    const IntegerVec apart =
        on_b.total * weighted_sum(bodies.a, on_a) - on_a.total * weighted_sum(bodies.b, on_b);
    return root_rounded_up(dot(apart, apart), totals * totals, bodies.unit);
}

/// Returns the separation of the bodies along a direction, either way; 0 if they are not separated.
double gap_along(ExactPair& bodies, const IntegerVec& direction) {
    if (direction.is_zero()) return 0;
    const mpz_class gap = std::max(bodies.lowest(direction).height, bodies.lowest(-direction).height);
    if (sgn(gap) <= 0) return 0;
    return root_rounded_down(gap * gap, dot(direction, direction), bodies.unit);
}

std::vector<Vec3d> chosen(std::span<const Vec3d> vertices, const Mean& mean) {
    std::vector<Vec3d> result;
    for (const std::uint32_t i : mean.vertices) result.push_back(vertices[i]);
    return result;
}

/// The line from one body to the other that exact_distance found between some of their vertices.
SubsetTrial<IntegerVec> line_between(ExactPair& bodies, const SimplexSeed& simplex, const Mean& on_a,
                                     const Mean& on_b) {
    MinimumSimplex<IntegerVec> found;
    found.size = simplex.size;
    for (int i = 0; i < simplex.size; ++i) {
        const VertexPair pair = simplex.pair[i];
        found.point[i] = bodies.difference({on_a.vertices[pair.a], on_b.vertices[pair.b]});
    }
    SubsetTrial<IntegerVec> line = subset_of<IntegerVec>(found, ~0U, nullptr);
    if (!find_direction(line))
        throw std::logic_error("certificate: a simplex of exact_distance has no nearest point");
    line.point = {};  // these pointers must not outlive `found`
    return line;
}

}  // namespace

Result<Certificate> certify(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                            const Pose& pose_b, const WitnessClaim& on_a, const WitnessClaim& on_b,
                            const Vec3d& direction) {
    if (std::string error = pair_error(a, pose_a, b, pose_b); !error.empty()) {
        return Result<Certificate>::failure(std::move(error));
    }
    ExactPair bodies(a, pose_a, b, pose_b);
    const Mean mean_a = mean_of(on_a, a.size());
    const Mean mean_b = mean_of(on_b, b.size());
    Certificate result;
    if (direction.allFinite()) result.lower = gap_along(bodies, scaled(direction, least_exponent(direction)));
    if (mean_a.is_weighted && mean_b.is_weighted) {
        result.upper = distance_of_means(bodies, mean_a, mean_b);
        return Result<Certificate>::success(result);
    }
    const auto best = exact_distance(chosen(a, mean_a), pose_a, chosen(b, mean_b), pose_b);
    const auto line = line_between(bodies, best->simplex, mean_a, mean_b);
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
