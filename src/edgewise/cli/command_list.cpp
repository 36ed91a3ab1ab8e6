// SPDX-License-Identifier: MIT
//
// `edgewise list`: the names that other commands take, printed from the registries themselves.
#include <fmt/format.h>

#include <map>

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/terminal/list_tables.hpp"
#include "edgewise/input/known_names.hpp"
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

using Json = nlohmann::json;

/// One entry per layout, its precisions gathered.
Json list_layouts() {
    Json result = Json::array();
    for (const bench::TableType& type : bench::table_types()) {
        if (result.empty() || result.back()["name"] != type.layout) {
            result.push_back({{"name", type.layout},
                              {"stores", type.stores},
                              {"derives", type.derives},
                              {"precisions", Json::array()},
                              {"algorithms", type.algorithms}});
        }
        result.back()["precisions"].push_back(type.precision);
    }
    return result;
}

Json list_probes() {
    return json_rows(bench::registered_probes(), [](const bench::Probe& probe) {
        return Json{{"name", probe.name}, {"summary", probe.summary}};
    });
}

Json list_algorithms() {
    return json_rows(bench::algorithms(), [](const bench::AlgorithmInfo& info) {
        return Json{{"name", info.name},
                    {"summary", info.summary},
                    {"needs", info.parts == Parts::support ? "vertices and neighbours" : "all features"}};
    });
}

Json list_of_scenes() {
    return json_rows(scene::list_scenes(), [](const scene::SceneInfo& scene) {
        const Json parameters = json_rows(scene.parameters, [](const scene::ParameterInfo& p) {
            return Json{{"name", p.name}, {"unit", p.unit}, {"meaning", p.meaning}, {"default", p.standard}};
        });
        return Json{{"name", scene.name}, {"meaning", scene.meaning}, {"parameters", parameters}};
    });
}

/// Those that come along, each with its text: to start one's own from.
Json list_scene_files() {
    return json_rows(scene::scene_texts(), [](const scene::SceneText& text) {
        const Json file = Json::parse(text.json);
        return Json{{"name", text.name}, {"note", file.value("note", "")}, {"file", file}};
    });
}

Json list_of_shapes() {
    return json_rows(scene::list_shapes(), [](const scene::ShapeInfo& shape) {
        return Json{{"name", shape.name},
                    {"vertices", shape.vertices},
                    {"edges", shape.edges},
                    {"faces", shape.faces}};
    });
}

Json list_families() {
    return json_rows(scene::hard_families(), [](const scene::HardFamily& family) {
        return Json{{"name", family.name}, {"varies", family.varies}, {"breaks", family.breaks}};
    });
}

/// Each as the file that it could be.
Json list_machines() {
    return json_rows(measure::cache_machines(), [](const measure::CacheMachine& machine) {
        return Json::parse(measure::cache_machine_json(machine));
    });
}

Json list_axes() {
    return json_rows(sweep::axes_known(), [](const sweep::AxisInfo& axis) {
        return Json{{"name", axis.name}, {"values", axis.values}, {"meaning", axis.summary}};
    });
}

Json list_plans() {
    return json_rows(sweep::plan_names(), [](const std::string& name) {
        const sweep::Plan plan = sweep::make_plan(name);
        const Json scenes = json_rows(plan.scenes, [](const sweep::SceneChoice& scene) {
            return scene.name + " " + Json(scene.parameters).dump();
        });
        return Json{{"name", name},
                    {"queries", plan.queries},
                    {"checked", plan.checked},
                    {"rounds", plan.rounds},
                    {"stability", plan.count_of("stability")},
                    {"layouts", plan.layouts},
                    {"axes", plan.axes},
                    {"scenes", scenes},
                    {"shapes", plan.shapes}};
    });
}

/// The part in braces differs from figure to figure of a family.
Json list_figures() {
    Json result = Json::array();
    for (const auto part : store::vocabulary_parts)
        for (const store::FigureInfo& figure : part)
            result.push_back({{"name", figure.key},
                              {"unit", figure.unit},
                              {"meaning", figure.meaning},
                              {"population", to_string(figure.population)},
                              {"deterministic", figure.repeats == store::Repeats::exactly}});
    return result;
}

const std::map<std::string, Json (*)()>& lists() {
    static const std::map<std::string, Json (*)()> known = {
        {"layouts", list_layouts},         {"probes", list_probes},    {"algorithms", list_algorithms},
        {"scenes", list_of_scenes},        {"shapes", list_of_shapes}, {"plans", list_plans},
        {"families", list_families},       {"axes", list_axes},        {"machines", list_machines},
        {"scene_files", list_scene_files}, {"figures", list_figures}};
    return known;
}

int run_list(const std::string& what, bool as_json) {
    if (!lists().contains(what)) {
        std::vector<std::string> names;
        for (const auto& [name, list] : lists()) names.push_back(name);
        throw std::invalid_argument(unknown_name("list", what, names));
    }
    const Json entries = lists().at(what)();
    if (as_json) {
        print_json(Json{{what, entries}});
        return exit_done;
    }
    fmt::print("{}", list_text(what, entries));
    return exit_done;
}

}  // namespace

void add_list(CLI::App& app, Context& context) {
    auto [command, what] = add_command(app, context, "list", "The names that other commands take", run_list);
    std::string names;
    for (const auto& [name, list] : lists()) names += (names.empty() ? "" : ", ") + name;
    command->add_option("what", what, "what to list: " + names);
}

}  // namespace edgewise::cli
