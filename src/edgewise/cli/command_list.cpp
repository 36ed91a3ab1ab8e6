// SPDX-License-Identifier: MIT
//
// `edgewise list`: the names that other commands take, printed from the registries themselves.
#include <fmt/format.h>

#include <map>

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

template <class Items, class Row>
json rows_of(const Items& items, Row row) {
    json result = json::array();
    for (const auto& item : items) result.push_back(row(item));
    return result;
}

json list_probes() {
    return rows_of(bench::registered_probes(), [](const bench::Probe& probe) {
        return json{{"name", probe.name}, {"summary", probe.summary}};
    });
}

json list_algorithms() {
    return rows_of(bench::algorithms(), [](const bench::AlgorithmInfo& info) {
        return json{{"name", info.name},
                    {"summary", info.summary},
                    {"needs", info.parts == Parts::support ? "vertices and neighbours" : "all features"}};
    });
}

json list_of_scenes() {
    return rows_of(scene::list_scenes(), [](const scene::SceneInfo& scene) {
        const json parameters = rows_of(scene.parameters, [](const scene::ParameterInfo& p) {
            return json{{"name", p.name}, {"unit", p.unit}, {"meaning", p.meaning}, {"default", p.standard}};
        });
        return json{{"name", scene.name}, {"meaning", scene.meaning}, {"parameters", parameters}};
    });
}

/// Those that come along, each with its text: to start one's own from.
json list_scene_files() {
    return rows_of(scene::scene_texts(), [](const scene::SceneText& text) {
        const json file = json::parse(text.json);
        return json{{"name", text.name}, {"note", file.value("note", "")}, {"file", file}};
    });
}

json list_of_shapes() {
    return rows_of(scene::list_shapes(), [](const scene::ShapeInfo& shape) {
        return json{{"name", shape.name},
                    {"vertices", shape.vertices},
                    {"edges", shape.edges},
                    {"faces", shape.faces}};
    });
}

json list_families() {
    return rows_of(scene::hard_families(), [](const scene::HardFamily& family) {
        return json{{"name", family.name}, {"varies", family.varies}, {"breaks", family.breaks}};
    });
}

/// Each level as size, ways and latency, with what its source does not prove.
json level_json(const measure::LevelGeometry& level, const measure::LevelOrigin& origin, std::uint32_t line) {
    return {{"name", level.name},      {"bytes", std::uint64_t{level.sets} * level.ways * line},
            {"ways", level.ways},      {"latency_cycles", origin.latency_cycles},
            {"source", origin.source}, {"unverified", origin.unverified}};
}

json list_machines() {
    return rows_of(measure::cache_machines(), [](const measure::CacheMachine& machine) {
        json levels = json::array();
        for (std::size_t i = 0; i < machine.origins.size(); ++i)
            levels.push_back(
                level_json(machine.caches.levels[i], machine.origins[i], machine.caches.line_bytes));
        return json{{"name", machine.name},
                    {"what", machine.what},
                    {"line_bytes", machine.caches.line_bytes},
                    {"levels", levels}};
    });
}

json list_axes() {
    return rows_of(sweep::axes_known(), [](const sweep::AxisInfo& axis) {
        return json{{"name", axis.name}, {"values", axis.values}, {"meaning", axis.summary}};
    });
}

json list_plans() {
    return rows_of(sweep::plan_names(), [](const std::string& name) {
        const sweep::Plan plan = sweep::make_plan(name);
        const json scenes = rows_of(plan.scenes, [](const sweep::SceneChoice& scene) {
            return scene.name + " " + json(scene.parameters).dump();
        });
        return json{{"name", name},
                    {"queries", plan.queries},
                    {"checked", plan.checked},
                    {"rounds", plan.rounds},
                    {"stability", plan.stability},
                    {"layouts", plan.layouts},
                    {"axes", plan.axes},
                    {"scenes", scenes},
                    {"shapes", plan.shapes}};
    });
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

int run_list(const std::string& what, bool as_json) {
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
    auto [command, what] = add_command(app, context, "list", "The names that other commands take", run_list);
    std::vector<std::string> names;
    for (const auto& [name, list] : lists()) names.push_back(name);
    command->add_option("what", what, "what to list")->required()->check(CLI::IsMember(names));
}

}  // namespace edgewise::cli
