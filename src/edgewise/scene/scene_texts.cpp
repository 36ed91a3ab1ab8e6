// SPDX-License-Identifier: MIT
#include "edgewise/scene/scene_texts.hpp"

namespace edgewise::scene {

std::optional<Result<SceneFile>> find_scene_file(const std::string& name_or_path) {
    for (const SceneText& text : scene_texts()) {
        if (text.name == name_or_path) return parse_scene_file(name_or_path, std::string(text.json));
    }
    if (name_or_path.ends_with(".json")) return read_scene_file(name_or_path);
    return std::nullopt;
}

}  // namespace edgewise::scene
