// SPDX-License-Identifier: MIT
//
// Input of the checks in truth: the claim that an answer makes, and the bodies of its query.
#pragma once

#include <cmath>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/truth/checked_answer.hpp"

namespace edgewise::scene {

[[nodiscard]] inline truth::Claim claim_of(const Distance& answer, bool verdict_only = false) {
    truth::Claim claim{.separated = answer.status == Status::separated,
                       .distance = answer.distance,
                       .verdict_only = verdict_only,
                       .failed = answer.status == Status::failed};
    if (claim.separated)
        claim.witness_error = std::abs(norm(Vec3d(answer.point_a - answer.point_b)) - answer.distance);
    return claim;
}

/// The bodies of a query where it has them. Keeps references.
[[nodiscard]] inline truth::PlacedBodies placed(std::span<const Polyhedron> bodies, const Query& query) {
    return {bodies[query.body_a].vertices, query.pose_a, bodies[query.body_b].vertices, query.pose_b};
}

}  // namespace edgewise::scene
