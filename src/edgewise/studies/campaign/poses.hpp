// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "edgewise/geometry/polyhedron.hpp"
#include "edgewise/geometry/pose.hpp"
#include "edgewise/geometry/split_mix.hpp"
#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/filter/float_proof.hpp"

namespace edgewise::studies::campaign {

// Seeds of a campaign's generators: of a block from the campaign's seed, of a pair from its block's.

/// Returns child `number` of a seed; children of neighbouring numbers are unrelated.
[[nodiscard]] constexpr std::uint64_t child_seed(std::uint64_t seed, std::uint64_t number) {
    std::uint64_t state = seed ^ (number * 0xd1342543de82ef95);
    const std::uint64_t first = split_mix(state);
    return first ^ split_mix(state);
}

// The shortest connection of two posed bodies as double computes it; poses are moved along it.

struct Separation {
    double distance = 0;
    Vec3d towards_b;  ///< unit, in the world
};

/// Returns nothing for bodies in contact, or for numbers that double cannot represent.
[[nodiscard]] inline std::optional<Separation> separation_of(truth::ScannedBody& a, truth::ScannedBody& b,
                                                             const std::pair<Pose, Pose>& poses) {
    const double as_good_as_it_gets = Tolerance<double>::eps * (a.extent() + b.extent());
    const truth::FloatProof proof =
        truth::prove_distance(a, poses.first, b, poses.second, Vec3d::Zero(), as_good_as_it_gets);
    const double distance = norm(proof.separation);
    if (!(proof.lower > 0 && distance > 0)) return std::nullopt;
    return Separation{distance, Vec3d(proof.separation / -distance)};
}

// Random poses of two bodies in the regimes that matter: free poses, and groups of poses that share their
// orientation, or nearly. Gaps and depths range from three sizes to 2^-36 of one. Of ten groups, two are
// nearly parallel, one is parallel, one is on a lattice.

/// Returns the first `count` poses of a block with this seed.
[[nodiscard]] std::vector<std::pair<Pose, Pose>> random_poses(const Polyhedron& a, const Polyhedron& b,
                                                              std::uint64_t seed, std::uint64_t count);

// Poses near those that a hard family made: hard cases come in neighbourhoods, and the next one may be a
// rounding step away from the known case.

/// Returns `made`, then poses near each of them in turn, up to `count`.
[[nodiscard]] std::vector<std::pair<Pose, Pose>> near_poses(const Polyhedron& a, const Polyhedron& b,
                                                            const std::vector<std::pair<Pose, Pose>>& made,
                                                            std::uint64_t seed, std::uint64_t count);

}  // namespace edgewise::studies::campaign
