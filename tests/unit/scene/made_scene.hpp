// SPDX-License-Identifier: MIT
//
// Workloads for the tests of scenes, and what is measured of them. Distances by brute force.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "brute_force.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::scene {

inline Workload made_scene(const char* name, const Polyhedron& body, std::size_t count,
                           const SceneParameters& given = {}, std::uint64_t seed = 1) {
    Result<Workload> workload = make_scene(name, body, given, seed, count, truth::brute_force_distance);
    EXPECT_TRUE(workload) << workload.error;
    return std::move(*workload);
}

inline double distance_of(const Workload& w, const Query& q) {
    return truth::brute_force_distance(w.bodies[q.body_a], q.pose_a, w.bodies[q.body_b], q.pose_b);
}

/// 2 sin(angle) times the axis of the turn from one orientation to the other, in the frame of the first.
inline Vec3d turn_between(const Mat3d& a, const Mat3d& b) {
    const Mat3d r = a.transpose() * b;
    return {r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)};
}

/// Angle between two orientations, by libm: the oracle.
inline double angle_between(const Mat3d& a, const Mat3d& b) {
    return std::atan2(norm(turn_between(a, b)), (a.transpose() * b).trace() - 1);
}

}  // namespace edgewise::scene
