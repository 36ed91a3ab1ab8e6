// SPDX-License-Identifier: MIT
#include "edgewise/sweep/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "edgewise/bench/registry.hpp"

namespace edgewise::sweep {

namespace {

/// Hulls of real objects from Debian's dart-doc, relative to the mesh folder: feet of two humanoids, a hand,
/// an arm's wrist.
constexpr const char* real_objects[] = {"atlas_foot.stl", "hubo_foot.stl", "atlas_hand.stl", "wam_wrist.stl"};

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

/// The plan with what the JSON says in place of it. Throws std::exception for what is no plan.
Plan read_plan(const nlohmann::json& json, Plan plan) {
    nlohmann::json scenes;
    Members(json)
        .take("scenes", scenes)
        .take("shapes", plan.shapes)
        .take("meshes", plan.meshes)
        .take("each_mesh", plan.each_mesh)
        .take("layouts", plan.layouts)
        .take("algorithms", plan.algorithms)
        .take("peers", plan.peers)
        .take("axes", plan.axes)
        .take("seed", plan.seed)
        .take("queries", plan.queries)
        .take("checked", plan.checked)
        .take("rounds", plan.rounds)
        .take("stability", plan.stability)
        .take("traced", plan.traced)
        .take("traced_steps", plan.traced_steps)
        .take("machines", plan.machines)
        .take("control", plan.control)
        .take("paging", plan.paging)
        .take("thrash", plan.thrash)
        .take("effort", plan.effort)
        .take("fields", plan.fields)
        .refuse_others();
    if (json.contains("meshes")) plan.meshes_required = true;
    if (json.contains("scenes")) {
        plan.scenes.clear();
        for (const auto& scene : scenes) plan.scenes.push_back(read_scene(scene));
    }
    return plan;
}

/// Mesh files of real objects; the set-up unpacks them beside the build folders: build/meshes for
/// build/release/edgewise.
std::vector<std::string> default_meshes() {
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    const auto folder = program.parent_path().parent_path() / "meshes";
    std::vector<std::string> result;
    for (const char* name : real_objects) result.push_back((folder / name).string());
    return result;
}

/// What no file of a plan can say, since it depends on the program: its layouts without those that hardly
/// differ from another, and the bodies that were unpacked beside it.
Plan plan_of_this_program() {
    Plan plan;
    plan.meshes = default_meshes();
    for (const bench::TableType& type : bench::table_types()) {
        if (type.variant_of.empty() && (plan.layouts.empty() || plan.layouts.back() != type.layout))
            plan.layouts.push_back(type.layout);
    }
    return plan;
}

Plan read_named(const PlanText& text) {
    Plan plan = text.name == "quick" ? plan_of_this_program() : make_plan("quick");
    plan = read_plan(nlohmann::json::parse(text.json), std::move(plan));
    plan.name = text.name;
    return plan;
}

Plan read_file(const std::string& file) {
    std::ifstream stream(file);
    if (!stream) {
        throw std::invalid_argument(fmt::format("unknown plan '{}'; known: {}, or a readable JSON file", file,
                                                fmt::join(plan_names(), ", ")));
    }
    try {
        Plan plan = read_plan(nlohmann::json::parse(stream), make_plan("quick"));
        plan.name = std::filesystem::path(file).stem().string();
        return plan;
    } catch (const std::exception& problem) {
        throw std::invalid_argument(fmt::format("plan {}: {}", file, problem.what()));
    }
}

bool is_built(const std::string& layout) {
    const auto types = bench::table_types();
    return std::any_of(types.begin(), types.end(), [&](const bench::TableType& type) {
        return type.layout == layout || type.name == layout;
    });
}

/// A program may have been built with some layouts only: the others, and scenes for them, are left out. Where
/// none is left, those that it has.
void leave_out_missing_layouts(Plan& plan) {
    std::erase_if(plan.layouts,
                  [](const std::string& layout) { return layout != "all" && !is_built(layout); });
    if (plan.layouts.empty()) plan.layouts = plan_of_this_program().layouts;
    std::erase_if(plan.scenes, [](SceneChoice& scene) {
        if (scene.layouts.empty()) return false;
        std::erase_if(scene.layouts, [](const std::string& layout) { return !is_built(layout); });
        return scene.layouts.empty();
    });
}

}  // namespace

std::vector<std::string> plan_names() {
    std::vector<std::string> names;
    for (const PlanText& text : plan_texts()) names.emplace_back(text.name);
    return names;
}

Plan make_plan(const std::string& name) {
    for (const PlanText& text : plan_texts()) {
        if (text.name != name) continue;
        Plan plan = read_named(text);
        leave_out_missing_layouts(plan);
        return plan;
    }
    return read_file(name);
}

}  // namespace edgewise::sweep
