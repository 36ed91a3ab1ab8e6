// SPDX-License-Identifier: MIT
//
// Every message names the body and what to give instead.
#include "edgewise/truth/pair_error.hpp"

namespace edgewise::truth {

namespace {

std::string body_error(std::span<const Vec3d> vertices, const Pose& pose, const char* body) {
    const std::string where = std::string("body ") + body + ": ";
    if (vertices.empty()) return where + "no vertices; give at least one point";
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (vertices[i].allFinite()) continue;
        return where + "vertex " + std::to_string(i) + " is not finite; give finite coordinates";
    }
    if (!pose.rotation.allFinite()) return where + "rotation is not finite; give nine finite numbers";
    if (!pose.translation.allFinite()) return where + "translation is not finite; give three finite numbers";
    return {};
}

}  // namespace

std::string pair_error(std::span<const Vec3d> a, const Pose& pose_a, std::span<const Vec3d> b,
                       const Pose& pose_b) {
    const std::string error = body_error(a, pose_a, "A");
    return error.empty() ? body_error(b, pose_b, "B") : error;
}

}  // namespace edgewise::truth
