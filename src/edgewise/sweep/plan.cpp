// SPDX-License-Identifier: MIT
#include "edgewise/sweep/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "edgewise/bench/build_info.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/input/count.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/sweep/study.hpp"

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
        try {
            if (json_.contains(name)) to = json_.at(name).get<Value>();
        } catch (const nlohmann::json::exception& fault) {  // "[json...] type must be array, but is string"
            const std::string_view what = fault.what();
            throw std::invalid_argument(fmt::format("{}: {}", name, what.substr(what.find(']') + 2)));
        }
        return *this;
    }

    template <class Whole>
    Members& count(std::string_view name, Whole& to, const input::CountRange& range) {
        known_.emplace_back(name);
        if (!json_.contains(name)) return *this;
        nlohmann::json number = json_.at(name);
        if (number.is_boolean() && range.most == 1) number = std::uint64_t{number.get<bool>()};
        const auto value = input::count_from(number, range);
        if (!value) throw std::invalid_argument(fmt::format("{} = {}", name, value.error));
        to = static_cast<Whole>(*value);
        return *this;
    }

    /// A misspelt member would be ignored in silence.
    void refuse_others() const {
        const std::string unknown = input::unknown_member(json_, "a plan", known_);
        if (!unknown.empty()) throw std::invalid_argument(unknown);
    }

  private:
    const nlohmann::json& json_;
    std::vector<std::string> known_;
};

SceneChoice read_scene(const nlohmann::json& json) {
    if (!json.is_object() || !json.contains("name"))
        throw std::invalid_argument("scenes must be a list of objects with a name: {\"name\": ..., ...}");
    SceneChoice scene;
    Members(json)
        .take("name", scene.name)
        .take("parameters", scene.parameters)
        .take("shapes", scene.shapes)
        .take("layouts", scene.layouts)
        .take("algorithms", scene.algorithms)
        .take("pairs", scene.pairs)
        .count("queries", scene.queries, input::queries_or_none)
        .take("plain", scene.plain)
        .take("axes", scene.axes)
        .take("caches", scene.caches)
        .take("optional", scene.optional)
        .refuse_others();
    return scene;
}

/// Returns the plan with the members of the JSON replaced. Throws std::exception if the JSON is not a plan.
Plan read_plan(const nlohmann::json& json, Plan plan) {
    if (!json.is_object())
        throw std::invalid_argument("the file must be one object: {\"scenes\": [...], ...}");
    std::vector<nlohmann::json> scenes;
    plan.processes = 1;
    Members members(json);
    members.take("scenes", scenes)
        .take("shapes", plan.shapes)
        .take("meshes", plan.meshes)
        .take("each_mesh", plan.each_mesh)
        .take("as_stored", plan.as_stored)
        .take("layouts", plan.layouts)
        .take("algorithms", plan.algorithms)
        .take("peers", plan.peers)
        .take("axes", plan.axes)
        .count("seed", plan.seed, input::seed_range)
        .count("queries", plan.queries, input::queries_range)
        .count("checked", plan.checked, input::queries_range)
        .count("rounds", plan.rounds, input::rounds_range)
        .count("processes", plan.processes, input::CountRange{1, 100, "processes"})
        .count("traced", plan.traced, input::queries_or_none)
        .count("traced_steps", plan.traced_steps, input::steps_or_none)
        .take("machines", plan.machines)
        .take("control", plan.control);
    for (const Study& study : registered_studies()) {
        std::size_t& count = plan.studies[std::string(study.name)];
        members.count(study.name, count, study.counts);
    }
    members.refuse_others();
    if (json.contains("meshes")) plan.meshes_required = true;
    if (json.contains("scenes")) {
        plan.scenes.clear();
        for (const auto& scene : scenes) plan.scenes.push_back(read_scene(scene));
    }
    return plan;
}

/// Returns the members that depend on this program, so that no plan file can have them: its layouts except
/// those that hardly differ from another, and the mesh files that were unpacked next to it.
Plan plan_of_this_program() {
    Plan plan;
    for (const char* name : real_objects) plan.meshes.push_back(file_beside_builds("meshes", name));
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
    const auto text = input::read_file_text(file);
    if (!text)
        throw std::invalid_argument(fmt::format("{}, or a readable JSON file ({})",
                                                unknown_name("plan", file, plan_names()), text.error));
    return parse_plan(file, *text);
}

/// A program may have been built with some layouts only: the others, and scenes for them, are left out. Where
/// none is left, those that it has.
void leave_out_missing_layouts(Plan& plan) {
    std::erase_if(plan.layouts,
                  [](const std::string& layout) { return layout != "all" && !bench::is_built(layout); });
    if (plan.layouts.empty()) plan.layouts = plan_of_this_program().layouts;
    std::erase_if(plan.scenes, [](SceneChoice& scene) {
        if (scene.layouts.empty() && scene.pairs.empty()) return false;
        std::erase_if(scene.layouts, [](const std::string& layout) { return !bench::is_built(layout); });
        std::erase_if(scene.pairs, [](const std::string& pair) {
            return !bench::is_built(pair.substr(pair.find(' ') + 1));
        });
        return scene.layouts.empty() && scene.pairs.empty();
    });
}

}  // namespace

std::string file_beside_builds(const char* folder, const std::string& name) {
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    return (program.parent_path().parent_path() / folder / name).string();
}

std::vector<std::string> plan_names() {
    std::vector<std::string> names;
    for (const PlanText& text : plan_texts()) names.emplace_back(text.name);
    return names;
}

Plan parse_plan(const std::string& file, const std::string& text) {
    try {
        Plan plan = read_plan(input::parse_json(text).or_throw(), make_plan("quick"));
        plan.name = std::filesystem::path(file).stem().string();
        return plan;
    } catch (const std::exception& problem) {
        throw std::invalid_argument(fmt::format("plan {}: {}", file, problem.what()));
    }
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
