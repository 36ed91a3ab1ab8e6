// SPDX-License-Identifier: MIT
//
// `edgewise list`: the names that other commands take, printed from the registries themselves.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/plan.hpp"

namespace edgewise::cli {

namespace {

using nlohmann::json;

/// One entry per layout, its precisions gathered.
json list_layouts() {
    json result = json::array();
    for (const bench::TableType& type : bench::table_types()) {
        if (result.empty() || result.back()["name"] != type.layout) {
            result.push_back({{"name", type.layout},
                              {"stores", type.stores},
                              {"derives", type.derives},
                              {"precisions", json::array()},
                              {"algorithms", type.algorithms}});
        }
        result.back()["precisions"].push_back(type.precision);
    }
    return result;
}

json list_probes() {
    json result = json::array();
    for (const auto& probe : bench::registered_probes())
        result.push_back({{"name", probe->name()}, {"summary", probe->summary()}});
    return result;
}

json list_algorithms() {
    json result = json::array();
    for (const bench::AlgorithmInfo& info : bench::algorithms()) {
        result.push_back(
            {{"name", info.name},
             {"summary", info.summary},
             {"needs", info.parts == Parts::support ? "vertices and neighbours" : "all features"}});
    }
    return result;
}

json list_of_scenes() {
    json result = json::array();
    for (const scene::SceneInfo& scene : scene::list_scenes()) {
        json parameters = json::array();
        for (const scene::ParameterInfo& p : scene.parameters) {
            parameters.push_back(
                {{"name", p.name}, {"unit", p.unit}, {"meaning", p.meaning}, {"default", p.standard}});
        }
        result.push_back({{"name", scene.name}, {"meaning", scene.meaning}, {"parameters", parameters}});
    }
    return result;
}

/// Those that come along, each with its text: to start one's own from.
json list_scene_files() {
    json result = json::array();
    for (const scene::SceneText& text : scene::scene_texts()) {
        json file = json::parse(text.json);
        result.push_back({{"name", text.name}, {"note", file.value("note", "")}, {"file", file}});
    }
    return result;
}

json list_of_shapes() {
    json result = json::array();
    for (const scene::ShapeInfo& shape : scene::list_shapes()) {
        result.push_back({{"name", shape.name},
                          {"vertices", shape.vertices},
                          {"edges", shape.edges},
                          {"faces", shape.faces}});
    }
    return result;
}

json list_families() {
    json result = json::array();
    for (const scene::HardFamily& family : scene::hard_families())
        result.push_back({{"name", family.name}, {"varies", family.varies}, {"breaks", family.breaks}});
    return result;
}

/// Each level as size, ways and latency, with what its source does not prove.
json level_json(const measure::LevelGeometry& level, const measure::LevelOrigin& origin, std::uint32_t line) {
    return {{"name", level.name},      {"bytes", std::uint64_t{level.sets} * level.ways * line},
            {"ways", level.ways},      {"latency_cycles", origin.latency_cycles},
            {"source", origin.source}, {"unverified", origin.unverified}};
}

json list_machines() {
    json result = json::array();
    for (const measure::CacheMachine& machine : measure::cache_machines()) {
        json levels = json::array();
        for (std::size_t i = 0; i < machine.origins.size(); ++i)
            levels.push_back(
                level_json(machine.caches.levels[i], machine.origins[i], machine.caches.line_bytes));
        result.push_back({{"name", machine.name},
                          {"what", machine.what},
                          {"line_bytes", machine.caches.line_bytes},
                          {"levels", levels}});
    }
    return result;
}

json list_axes() {
    json result = json::array();
    for (const sweep::AxisInfo& axis : sweep::axes_known())
        result.push_back({{"name", axis.name}, {"values", axis.values}, {"meaning", axis.summary}});
    return result;
}

json list_plans() {
    json result = json::array();
    for (const std::string& name : sweep::plan_names()) {
        const sweep::Plan plan = sweep::make_plan(name);
        json scenes = json::array();
        for (const sweep::SceneChoice& scene : plan.scenes)
            scenes.push_back(scene.name + " " + json(scene.parameters).dump());
        result.push_back({{"name", name},
                          {"queries", plan.queries},
                          {"checked", plan.checked},
                          {"rounds", plan.rounds},
                          {"stability", plan.stability},
                          {"layouts", plan.layouts},
                          {"axes", plan.axes},
                          {"scenes", scenes},
                          {"shapes", plan.shapes}});
    }
    return result;
}

/// What stands in braces differs from figure to figure of a family.
json list_figures() {
    json result = json::array();
    for (const auto part : store::vocabulary_parts)
        for (const store::FigureInfo& figure : part)
            result.push_back({{"name", figure.key},
                              {"unit", figure.unit},
                              {"meaning", figure.meaning},
                              {"population", to_string(figure.population)},
                              {"deterministic", figure.repeats == store::Repeats::exactly}});
    return result;
}

const std::map<std::string, json (*)()>& lists() {
    static const std::map<std::string, json (*)()> known = {
        {"layouts", list_layouts},         {"probes", list_probes},    {"algorithms", list_algorithms},
        {"scenes", list_of_scenes},        {"shapes", list_of_shapes}, {"plans", list_plans},
        {"families", list_families},       {"axes", list_axes},        {"machines", list_machines},
        {"scene_files", list_scene_files}, {"figures", list_figures}};
    return known;
}

int run(const std::string& what, bool as_json) {
    const json entries = lists().at(what)();
    if (as_json) {
        fmt::print("{}\n", json{{what, entries}}.dump());
        return exit_done;
    }
    for (const json& entry : entries) {
        fmt::print("{}\n", entry["name"].get<std::string>());
        for (const auto& [key, value] : entry.items()) {
            if (key != "name")
                fmt::print("    {}: {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
        }
    }
    return exit_done;
}

}  // namespace

void add_list(CLI::App& app, Context& context) {
    auto what = std::make_shared<std::string>();
    CLI::App* command = add_command(app, context, "list", "The names that other commands take");
    std::vector<std::string> names;
    for (const auto& [name, list] : lists()) names.push_back(name);
    command->add_option("what", *what, "what to list")->required()->check(CLI::IsMember(names));
    command->callback(
        [what, &context] { context.action = [=, &context] { return run(*what, context.json); }; });
}

}  // namespace edgewise::cli
