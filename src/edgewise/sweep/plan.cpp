// SPDX-License-Identifier: MIT
#include "edgewise/sweep/plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>

#include "edgewise/bench/registry.hpp"
#include "edgewise/sweep/paper_plan.hpp"

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
SceneChoice pressure(double bodies, const std::vector<std::string>& layouts) {
    SceneChoice scene{"pressure", {{"bodies", bodies}}};
    scene.shapes = {"sphere386"};
    for (const bench::TableType& type :
         bench::table_types()) {  // a program may have been built with some only
        for (const std::string& wanted : layouts) {
            if (wanted == type.layout || wanted == type.name) scene.layouts.push_back(type.name);
        }
    }
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
    for (const SceneChoice& scene :
         {pressure(600, {"aos", "lean", "quantised"}), pressure(6000, {"aos_f64", "lean_f64"})}) {
        if (!scene.layouts.empty()) plan.scenes.push_back(scene);
    }
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

/// The paper's own scenes (paper_plan.cpp), its sample size (30 000 queries a sample point) and control,
/// exact checks to match; and the widely different layouts on coherent motion and on independent pairs.
Plan paper() {
    Plan plan = base("paper");
    plan.scenes = paper_scenes();
    for (const char* name : {"tumble", "cold"}) {
        plan.scenes.push_back({name, {}, {"sphere38", "sphere386"}});
        plan.scenes.back().queries = 3000;
    }
    plan.queries = 30000;
    plan.checked = 2000;
    plan.control = true;
    plan.rounds = 11;
    plan.stability = 100;
    plan.traced = 3000;
    plan.paging = 600;
    plan.machines = {"pentium2_deschutes", "pentium3_coppermine", "athlon_thunderbird", "zen5", "host"};
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

template <class Value>
void take(const nlohmann::json& from, const char* key, Value& to) {
    if (from.contains(key)) to = from.at(key).get<Value>();
}

constexpr std::array members = {"scenes", "shapes",   "meshes",  "each_mesh", "layouts", "algorithms",
                                "axes",   "seed",     "queries", "checked",   "rounds",  "stability",
                                "traced", "machines", "control", "paging"};

/// A misspelt member would be ignored in silence.
void refuse_unknown_members(const nlohmann::json& json, std::span<const char* const> known) {
    for (const auto& [key, value] : json.items()) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        throw std::invalid_argument(
            fmt::format("unknown member '{}'; known: {}", key, fmt::join(known, ", ")));
    }
}

SceneChoice read_scene(const nlohmann::json& json) {
    constexpr std::array known = {"name",    "parameters", "shapes", "layouts", "algorithms",
                                  "queries", "plain",      "axes",   "caches"};
    refuse_unknown_members(json, known);
    SceneChoice scene{json.at("name"), json.value("parameters", scene::SceneParameters{})};
    take(json, "shapes", scene.shapes);
    take(json, "layouts", scene.layouts);
    take(json, "algorithms", scene.algorithms);
    take(json, "queries", scene.queries);
    take(json, "plain", scene.plain);
    take(json, "axes", scene.axes);
    take(json, "caches", scene.caches);
    return scene;
}

Plan read_plan(const std::string& file) {
    std::ifstream stream(file);
    if (!stream) {
        throw std::invalid_argument(fmt::format("unknown plan '{}'; known: {}, or a readable JSON file", file,
                                                fmt::join(plan_names(), ", ")));
    }
    Plan plan = quick();
    plan.name = std::filesystem::path(file).stem().string();
    try {
        const auto json = nlohmann::json::parse(stream);
        refuse_unknown_members(json, members);
        if (json.contains("scenes")) {
            plan.scenes.clear();
            for (const auto& scene : json.at("scenes")) plan.scenes.push_back(read_scene(scene));
        }
        take(json, "shapes", plan.shapes);
        take(json, "meshes", plan.meshes);
        plan.meshes_required = json.contains("meshes");
        take(json, "each_mesh", plan.each_mesh);
        take(json, "layouts", plan.layouts);
        take(json, "algorithms", plan.algorithms);
        take(json, "axes", plan.axes);
        take(json, "seed", plan.seed);
        take(json, "queries", plan.queries);
        take(json, "checked", plan.checked);
        take(json, "rounds", plan.rounds);
        take(json, "stability", plan.stability);
        take(json, "traced", plan.traced);
        take(json, "control", plan.control);
        take(json, "paging", plan.paging);
        take(json, "machines", plan.machines);
    } catch (const std::exception& problem) {
        throw std::invalid_argument(fmt::format("plan {}: {}", file, problem.what()));
    }
    return plan;
}

}  // namespace

std::vector<std::string> plan_names() { return {"quick", "paper", "full"}; }

std::vector<std::string> default_meshes() {
    // The set-up unpacks them beside the build folders: build/meshes for build/release/edgewise.
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    const auto folder = program.parent_path().parent_path() / "meshes";
    std::vector<std::string> result;
    for (const char* name : real_objects) result.push_back((folder / name).string());
    return result;
}

Plan make_plan(const std::string& name) {
    if (name == "quick") return quick();
    if (name == "paper") return paper();
    if (name == "full") return full();
    return read_plan(name);
}

}  // namespace edgewise::sweep
