// SPDX-License-Identifier: MIT
//
// The answer of every algorithm. Points are in the frame of body A, where queries run; `to_world` transforms
// them to world coordinates.
#pragma once

#include <cstdint>
#include <string_view>

#include "edgewise/geometry/inlining.hpp"
#include "edgewise/geometry/pose.hpp"

namespace edgewise {

enum class Status : std::uint8_t {
    separated,    ///< distance > 0
    touching,     ///< distance 0 (or within a tolerance asked for) and no common interior found:
                  ///< `penetration` decides if there is one
    overlapping,  ///< distance 0 and a common interior point
    failed,       ///< no answer; the caller says why
};

[[nodiscard]] constexpr std::string_view to_string(Status status) {
    constexpr std::string_view names[] = {"separated", "touching", "overlapping", "failed"};
    return names[static_cast<int>(status)];
}

struct Distance {
    Status status = Status::failed;
    double distance = 0;            ///< 0 in contact, except for what a contact tolerance allows
    Vec3d point_a = Vec3d::Zero();  ///< witness on A, in A's frame; when overlapping, no claim is made
    Vec3d point_b = Vec3d::Zero();  ///< witness on B, in A's frame
    /// Unit, from A to B: a plane normal to it separates the bodies, and B moved along it gets farther away.
    /// For close bodies it is more accurate than the difference of the witness points, with rounding that may
    /// exceed their distance. Zero in contact, where `penetration` gives the normal of the least way out.
    Vec3d normal = Vec3d::Zero();
    int steps = 0;        ///< V-Clip states visited, or GJK iterations
    int cycles = 0;       ///< runs that came back to a state already seen
    int fallbacks = 0;    ///< answers taken from the complete fallback instead
    int refinements = 0;  ///< close or doubtful answers computed again from where the run ended
    int escapes = 0;      ///< local minima under a face that V-Clip left for a better face
};

/// Returns the answer with witness points and normal in world coordinates. Flattened as `relative_pose` is.
[[nodiscard]] EDGEWISE_FLATTENED inline Distance to_world(const Distance& answer, const Pose& pose_a) {
    // Field by field: a copy of the whole would wait for the query's last stores.
    return {.status = answer.status,
            .distance = answer.distance,
            .point_a = pose_a.apply(answer.point_a),
            .point_b = pose_a.apply(answer.point_b),
            .normal = multiply(pose_a.rotation, answer.normal),
            .steps = answer.steps,
            .cycles = answer.cycles,
            .fallbacks = answer.fallbacks,
            .refinements = answer.refinements,
            .escapes = answer.escapes};
}

/// Makes an answer from two witness points that are known to be closest.
template <class Scalar>
[[nodiscard]] Distance between(const Vec3<Scalar>& on_a, const Vec3<Scalar>& on_b) {
    const Vec3<Scalar> offset = on_b - on_a;
    const Scalar distance = norm(offset);
    Distance answer;
    answer.distance = distance;
    answer.status = distance > 0 ? Status::separated : Status::touching;
    answer.point_a = on_a.template cast<double>();
    answer.point_b = on_b.template cast<double>();
    if (distance > 0) answer.normal = Vec3<Scalar>(offset * (1 / distance)).template cast<double>();
    return answer;
}

}  // namespace edgewise
