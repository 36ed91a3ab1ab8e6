// SPDX-License-Identifier: MIT
//
// GJK on integers. Each step adds the lowest point along the direction to the simplex, and the distance
// shrinks strictly, so no simplex comes twice and the loop ends.
#include "edgewise/truth/exact_distance.hpp"

#include <stdexcept>
#include <string>

#include "edgewise/truth/depth/common_interior.hpp"
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
