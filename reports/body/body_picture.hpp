// SPDX-License-Identifier: MIT
//
// A body seen from one side, its vertices, edges and faces coloured by how often they are read. The
// page's script draws the same paths again when the body is turned.
#pragma once

#include <string>

#include "edgewise/reports/body/body_heat.hpp"

namespace edgewise::reports {

/// Angles of the first view, in radians: about the vertical axis, then about the horizontal one.
inline constexpr double body_yaw = 0.6, body_pitch = 0.4;

[[nodiscard]] std::string body_svg(const HeatBody& body, const BodyHeat& heat);

/// Returns the bodies and their heats as JSON for the script: {"bodies": {shape: {"vertices", "edges",
/// "faces"}}, "heats": [{"title", "said", "shape", "vertices", "edges", "faces"}]}.
[[nodiscard]] std::string bodies_data(const HeatOnBodies& heat);

}  // namespace edgewise::reports
