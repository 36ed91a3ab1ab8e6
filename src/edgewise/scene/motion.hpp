// SPDX-License-Identifier: MIT
//
// Coherent motion: a body drifts with constant velocity, turns by the same angle every step, about its own
// axis (which is fixed, or turns itself by the same angle every step), and is reflected by the walls of a
// box. Bodies ignore each other: they overlap and pass through one another, because the scene measures
// detection, not response.
//
// Walls act on the centre (the mean of the vertices, a point inside every body), so a body may stick out.
#pragma once

#include "edgewise/geometry/pose.hpp"
#include "edgewise/scene/quaternion.hpp"

namespace edgewise::scene {

struct MovingBody {
    Vec3d centre;    ///< of the body, in the world
    Vec3d velocity;  ///< metres per step
    Quaternion orientation;
    Quaternion turn;            ///< rotation of one step
    Quaternion axis_turn = {};  ///< by which that rotation's axis turns in one step
};

/// The pose of a body of this centre in its own frame.
[[nodiscard]] Pose pose_of(const MovingBody& body, const Vec3d& centre);

/// The rotation by `angle` radians about a unit axis; any angle up to 2^20 turns (angle.hpp).
[[nodiscard]] Quaternion rotation_about(const Vec3d& axis, double angle);

/// One step on: moved, turned, and reflected at the walls of [-half, half]^3.
void advance(MovingBody& body, double half);

/// Pose that turns a body about `centre` (body frame) and then puts that point at `place` (world).
[[nodiscard]] Pose pose_at(const Mat3d& rotation, const Vec3d& centre, const Vec3d& place);

}  // namespace edgewise::scene
