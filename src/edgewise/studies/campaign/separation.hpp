// SPDX-License-Identifier: MIT
//
// The shortest connection of two posed bodies as double computes it; poses are moved along it.
#pragma once

#include <optional>
#include <utility>

#include "edgewise/geometry/tolerance.hpp"
#include "edgewise/truth/filter/float_proof.hpp"

namespace edgewise::studies::campaign {

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

}  // namespace edgewise::studies::campaign
