// SPDX-License-Identifier: MIT
//
// The one place that talks to Assimp, which knows the other formats and reads them in single precision.
#pragma once

#include <string>
#include <vector>

#include "edgewise/geometry/result.hpp"
#include "edgewise/input/guarded.hpp"
#include "edgewise/scene/mesh/mesh_parts.hpp"

namespace edgewise::scene {

/// One part for each use of a mesh by a node, with the transforms of all nodes above it applied in double.
/// Fails on a file that Assimp cannot read, or whose reader takes more than the limits. An error begins with
/// ": "; the warning says what was done to a COLLADA file's axes and unit, which `as_stored` leaves out.
[[nodiscard]] Result<std::vector<MeshPart>> assimp_parts(const std::string& path, bool as_stored,
                                                         const input::GuardLimits& limits);

}  // namespace edgewise::scene
