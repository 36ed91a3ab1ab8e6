// SPDX-License-Identifier: MIT
//
// The scene files that come with Edgewise: the scenes of "New Metrics for Evaluation of Collision Detection
// Techniques", one for each of its tests and figures (reports/paper/scenes). Sweeps and files name them like
// kinds of scenes.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "edgewise/scene/scene_file.hpp"

namespace edgewise::scene {

struct SceneText {
    std::string_view name, json;
};

[[nodiscard]] std::span<const SceneText> scene_texts();

/// The scene file of that name, or at that path if it ends in .json; nothing for any other name.
[[nodiscard]] std::optional<Result<SceneFile>> find_scene_file(const std::string& name_or_path);

}  // namespace edgewise::scene
