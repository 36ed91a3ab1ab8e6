// SPDX-License-Identifier: MIT
#include "edgewise/sweep/scene_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/store/schema.hpp"

namespace edgewise::sweep {

namespace {

bool is_path(const std::string& name) {
    const auto texts = scene::scene_texts();
    return name.ends_with(".json") &&
           std::ranges::none_of(texts, [&](const scene::SceneText& text) { return text.name == name; });
}

}  // namespace

std::string scene_id(std::string name) {
    for (char& c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (!std::isalnum(byte) && c != '_' && c != '-') c = '_';
    }
    return name;
}

std::string owner_of_scene_name(const std::string& name) {
    const std::string id = scene_id(name);
    for (const scene::SceneInfo& kind : scene::list_scenes()) {
        if (id == kind.name) return fmt::format("the kind of scene '{}'", kind.name);
    }
    for (const scene::SceneText& text : scene::scene_texts()) {
        if (id == text.name) return fmt::format("the scene file '{}' that comes along", text.name);
    }
    return {};
}

void check_scene_names(const Plan& plan) {
    std::map<std::string, std::string> paths;  // by id
    for (const SceneChoice& scene : plan.scenes) {
        if (!is_path(scene.name)) continue;
        const std::filesystem::path path = scene.name;
        if (const std::string owner = owner_of_scene_name(path.stem().string()); !owner.empty())
            throw std::invalid_argument(
                fmt::format("scene file {}: its name is that of {}: rename the file", scene.name, owner));
        const auto [first, is_new] = paths.try_emplace(scene_id(path.stem().string()), scene.name);
        std::error_code error;
        if (!is_new && !std::filesystem::equivalent(first->second, path, error))
            throw std::invalid_argument(
                fmt::format("scene files {} and {} would go by one name, '{}': rename one", first->second,
                            scene.name, first->first));
    }
}

void check_scene_files(const SweepWork& work, const store::Store& store) {
    for (const SceneWork& scene : work.scenes) {
        const auto stored = store.meta(store::scene_file_key + scene.choice.name);
        if (scene.json.empty() || !stored || *stored == scene.json) continue;
        const std::string earlier =
            store.meta(store::scene_path_key + scene.choice.name).value_or("an earlier run's file");
        throw std::invalid_argument(fmt::format(
            "scene file {}: the store holds a different scene of this name, '{}', from {}: rename "
            "the file or name another store",
            scene.path, scene.choice.name, earlier));
    }
}

}  // namespace edgewise::sweep
