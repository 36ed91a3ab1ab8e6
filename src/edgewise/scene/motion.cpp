// SPDX-License-Identifier: MIT
//
// Steps of coherent motion, in IEEE + - * / sqrt only.
#include "edgewise/scene/motion.hpp"

#include <cassert>

#include "edgewise/scene/angle.hpp"

namespace edgewise::scene {

Quaternion rotation_about(const Vec3d& axis, double angle) {
    const SineCosine half = half_angle_sine_cosine(angle);
    return normalised({half.cosine, half.sine * axis.x(), half.sine * axis.y(), half.sine * axis.z()});
}

/// A coordinate folded back between the walls -half and half; each reflection flips the velocity.
static void reflect(double& coordinate, double& velocity, double half) {
    assert(half > 0 && std::isfinite(coordinate));
    while (coordinate > half || coordinate < -half) {
        coordinate = (coordinate > half ? 2 * half : -2 * half) - coordinate;
        velocity = -velocity;
    }
}

void advance(MovingBody& body, double half) {
    body.centre += body.velocity;
    for (int axis = 0; axis < 3; ++axis) reflect(body.centre[axis], body.velocity[axis], half);
    body.orientation = normalised(body.turn * body.orientation);
    const Quaternion& p = body.axis_turn;
    if (p.w != 1) body.turn = normalised(p * body.turn * Quaternion{p.w, -p.x, -p.y, -p.z});
}

Pose pose_of(const MovingBody& body, const Vec3d& centre) {
    return pose_at(rotation_matrix(body.orientation), centre, body.centre);
}

Pose pose_at(const Mat3d& rotation, const Vec3d& centre, const Vec3d& place) {
    return {rotation, place - multiply(rotation, centre)};
}

}  // namespace edgewise::scene
