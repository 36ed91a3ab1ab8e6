// SPDX-License-Identifier: MIT
//
// What a runner answers beyond a bare distance.
#pragma once

#include <cstddef>
#include <vector>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/geometry/feature.hpp"
#include "edgewise/geometry/polyhedron.hpp"

namespace edgewise::bench {

/// An answer with everything a user may ask for, in world coordinates. In contact the witness points are
/// those of the penetration: each body's point deepest in the other.
struct NamedAnswer {
    Distance distance;
    NamedFeature feature_a, feature_b;
    double depth = 0;              ///< 0 unless in contact
    bool depth_cut_short = false;  ///< EPA's work space was full: the depth is an upper bound
    Vec3d normal = Vec3d::Zero();  ///< in contact: B moved by depth * normal only touches A
    std::vector<Index> proof_a,
        proof_b;  ///< in contact: stored vertices with hulls that hold a common point, or nearly
};

/// Answers of another pass, to be compared with those of the timed pass: the number of the workload's first
/// queries, and the sum of their distances in order, with the same bits if they agree.
struct PassSum {
    std::size_t queries = 0;
    double distances = 0;
};

}  // namespace edgewise::bench
