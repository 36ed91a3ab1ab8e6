// SPDX-License-Identifier: MIT
//
// The scenes of "New Metrics for Evaluation of Collision Detection Techniques" (src/scene/paper), and which
// layouts and axes each is measured with.
#pragma once

#include <vector>

#include "edgewise/sweep/plan.hpp"

namespace edgewise::sweep {

/// Of the table types that this program has.
[[nodiscard]] std::vector<SceneChoice> paper_scenes();

}  // namespace edgewise::sweep
