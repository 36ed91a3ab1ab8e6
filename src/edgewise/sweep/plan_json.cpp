// SPDX-License-Identifier: MIT
#include "edgewise/sweep/plan_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace edgewise::sweep {

namespace {

/// Takes an object's members one by one.
class Members {
  public:
    explicit Members(const nlohmann::json& json) : json_(json) {}

    template <class Value>
    Members& take(const char* name, Value& to) {
        known_.push_back(name);
        if (json_.contains(name)) to = json_.at(name).get<Value>();
        return *this;
    }

    /// A misspelt member would be ignored in silence.
    void refuse_others() const {
        for (const auto& [key, value] : json_.items()) {
            if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
            throw std::invalid_argument(
                fmt::format("unknown member '{}'; known: {}", key, fmt::join(known_, ", ")));
        }
    }

  private:
    const nlohmann::json& json_;
    std::vector<std::string> known_;
};

SceneChoice read_scene(const nlohmann::json& json) {
    SceneChoice scene{json.at("name")};
    Members(json)
        .take("name", scene.name)
        .take("parameters", scene.parameters)
        .take("shapes", scene.shapes)
        .take("layouts", scene.layouts)
        .take("algorithms", scene.algorithms)
        .take("queries", scene.queries)
        .take("plain", scene.plain)
        .take("axes", scene.axes)
        .take("caches", scene.caches)
        .refuse_others();
    return scene;
}

}  // namespace

Plan read_plan(const nlohmann::json& json, Plan plan) {
    nlohmann::json scenes;
    Members(json)
        .take("scenes", scenes)
        .take("shapes", plan.shapes)
        .take("meshes", plan.meshes)
        .take("each_mesh", plan.each_mesh)
        .take("layouts", plan.layouts)
        .take("algorithms", plan.algorithms)
        .take("axes", plan.axes)
        .take("seed", plan.seed)
        .take("queries", plan.queries)
        .take("checked", plan.checked)
        .take("rounds", plan.rounds)
        .take("stability", plan.stability)
        .take("traced", plan.traced)
        .take("machines", plan.machines)
        .take("control", plan.control)
        .take("paging", plan.paging)
        .refuse_others();
    if (json.contains("meshes")) plan.meshes_required = true;
    if (json.contains("scenes")) {
        plan.scenes.clear();
        for (const auto& scene : scenes) plan.scenes.push_back(read_scene(scene));
    }
    return plan;
}

}  // namespace edgewise::sweep
