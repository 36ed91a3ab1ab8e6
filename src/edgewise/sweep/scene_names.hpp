// SPDX-License-Identifier: MIT
//
// The names of a plan's scene files. A scene's name is its file's, and its charts, its table of results and
// its rows in the store go by it: two scenes of one name would be shown as one, and one named like a scene
// that comes along would stand in its place.
#pragma once

#include <string>

#include "edgewise/store/store.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

/// Throws std::invalid_argument that names both when two scenes of the plan would go by one name, or a file's
/// name is that of a kind of scene or of a scene file that comes along.
void check_scene_names(const Plan& plan);

/// What files and charts of a scene are called: letters, digits, _ and -.
[[nodiscard]] std::string scene_id(std::string name);

/// Empty, or whose name it is that a user's scene file may not have.
[[nodiscard]] std::string owner_of_scene_name(const std::string& name);

/// Throws std::invalid_argument that names both files when the store holds another scene of the name of one
/// of the work's scene files.
void check_scene_files(const SweepWork& work, const store::Store& store);

}  // namespace edgewise::sweep
