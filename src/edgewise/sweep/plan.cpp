// SPDX-License-Identifier: MIT
#include "edgewise/sweep/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "edgewise/bench/registry.hpp"
#include "edgewise/sweep/plan_json.hpp"

namespace edgewise::sweep {

namespace {

/// Hulls of real objects from Debian's dart-doc, relative to the mesh folder: feet of two humanoids, a hand,
/// an arm's wrist.
constexpr const char* real_objects[] = {"atlas_foot.stl", "hubo_foot.stl", "atlas_hand.stl", "wam_wrist.stl"};

/// Of this program, without those that hardly differ from another.
std::vector<std::string> widely_different_layouts() {
    std::vector<std::string> names;
    for (const bench::TableType& type : bench::table_types()) {
        if (type.variant_of.empty() && (names.empty() || names.back() != type.layout))
            names.push_back(type.layout);
    }
    return names;
}

/// A table for each of so many bodies, of the layouts whose size is the question: two steps, of which the
/// second starts warm.
SceneChoice pressure(double bodies, std::vector<std::string> layouts) {
    SceneChoice scene{"pressure", {{"bodies", bodies}}};
    scene.shapes = {"sphere386"};
    scene.layouts = std::move(layouts);
    scene.algorithms = {"vclip"};
    scene.queries = 2 * (static_cast<std::size_t>(bodies) - 1);
    scene.plain = true;
    return scene;
}

/// Shared by all named plans: the widely different layouts, every algorithm; tumble from nearly still to
/// incoherent.
Plan base(std::string name) {
    Plan plan;
    plan.name = std::move(name);
    plan.scenes = {{"static", {}},
                   {"cold", {}},
                   {"tumble", {{"rotation_step", 0.01}}},
                   {"tumble", {{"rotation_step", 0.1}}},
                   {"tumble", {{"rotation_step", 1}}}};
    plan.scenes.push_back({"tumble", {{"rotation_step", 0.1}, {"bodies", 100}, {"in_time_order", 1}}});
    plan.scenes.back().shapes = {"sphere386"};
    plan.scenes.push_back(pressure(600, {"aos", "lean", "quantised"}));
    plan.scenes.push_back(pressure(6000, {"aos_f64", "lean_f64"}));
    plan.shapes = {"tetra4", "cube8", "sphere38", "sphere386"};
    plan.meshes = default_meshes();
    plan.layouts = widely_different_layouts();
    plan.algorithms = {"all"};
    plan.machines = {"pentium3_coppermine", "skylake_sp", "zen5", "host"};
    return plan;
}

/// Caches are modelled for these shapes, but not where tables take a gigabyte: the model keeps 30 bytes for
/// each line of it.
void model_caches(Plan& plan, const std::vector<std::string>& shapes,
                  const std::function<bool(const SceneChoice&)>& wanted) {
    for (SceneChoice& scene : plan.scenes) {
        const auto bodies = scene.parameters.find("bodies");
        const bool large = bodies != scene.parameters.end() && bodies->second > 1000;
        if (!large && wanted(scene)) scene.caches = shapes;
    }
}

/// Some minutes on two cores: enough to choose a layout by.
Plan quick() {
    Plan plan = base("quick");
    plan.queries = 3000;
    plan.checked = 200;
    plan.rounds = 17;
    plan.stability = 20;
    plan.traced = 1000;
    model_caches(plan, {"sphere386"}, [](const SceneChoice& scene) {
        return scene.name == "pressure" || scene.parameters.contains("in_time_order") ||
               scene.parameters == scene::SceneParameters{{"rotation_step", 1}};
    });
    return plan;
}

/// Over all layouts, more sizes and speeds; further axes one at a time around the plain cells.
Plan full() {
    Plan plan = base("full");
    plan.queries = 30000;
    plan.checked = 2000;
    plan.rounds = 25;
    plan.stability = 200;
    plan.traced = 3000;
    model_caches(plan, {"cube8", "sphere38", "sphere386"}, [](const SceneChoice&) { return true; });
    plan.layouts = {"all"};
    plan.shapes = {"tetra4",    "cube8",        "sphere38",   "sphere102",
                   "sphere386", "uv_sphere386", "sphere1538", "sphere6146"};
    for (const double rotation : {0.001, 0.03, 0.3})
        plan.scenes.push_back({"tumble", {{"rotation_step", rotation}}});
    plan.axes = {"contact_tolerance=0.001", "gap_tolerance=1e-06",  "gap_tolerance=0.01", "order=bfs",
                 "order=spatial",           "sharing=per_instance", "allocator=jemalloc", "allocator=libc"};
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

std::optional<Plan> named_plan(const std::string& name) {
    if (name == "quick") return quick();
    if (name == "full") return full();
    for (const PlanText& text : plan_texts()) {
        if (text.name != name) continue;
        Plan plan = read_plan(nlohmann::json::parse(text.json), quick());
        plan.name = name;
        return plan;
    }
    return std::nullopt;
}

bool is_built(const std::string& layout) {
    const auto types = bench::table_types();
    return std::any_of(types.begin(), types.end(), [&](const bench::TableType& type) {
        return type.layout == layout || type.name == layout;
    });
}

/// A program may have been built with some layouts only: scenes for others are left out.
void leave_out_missing_layouts(Plan& plan) {
    std::erase_if(plan.scenes, [](SceneChoice& scene) {
        if (scene.layouts.empty()) return false;
        std::erase_if(scene.layouts, [](const std::string& layout) { return !is_built(layout); });
        return scene.layouts.empty();
    });
}

}  // namespace

std::vector<std::string> plan_names() {
    std::vector<std::string> names = {"quick"};
    for (const PlanText& text : plan_texts()) names.emplace_back(text.name);
    names.push_back("full");
    return names;
}

std::vector<std::string> default_meshes() {
    // The set-up unpacks them beside the build folders: build/meshes for build/release/edgewise.
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    const auto folder = program.parent_path().parent_path() / "meshes";
    std::vector<std::string> result;
    for (const char* name : real_objects) result.push_back((folder / name).string());
    return result;
}

Plan make_plan(const std::string& name) {
    auto plan = named_plan(name);
    if (!plan) return read_file(name);
    leave_out_missing_layouts(*plan);
    return *plan;
}

}  // namespace edgewise::sweep
