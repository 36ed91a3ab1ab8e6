// SPDX-License-Identifier: MIT
//
// `edgewise list`: the names that other commands take, printed from the registries themselves.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/registry.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/measure/cache/cache_machine.hpp"
#include "edgewise/reports/tables/text_grid.hpp"
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/store/vocabulary.hpp"
#include "edgewise/sweep/axes.hpp"
#include "edgewise/sweep/plan.hpp"

namespace edgewise::scene {
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ShapeInfo, name, vertices, edges, faces)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(HardFamily, name, varies, breaks)
}  // namespace edgewise::scene

namespace edgewise::cli {

namespace {

using Json = nlohmann::json;

using reports::wrapped, reports::rows_text, reports::widest_line;

/// Each scene with a table of its parameters.
std::string scenes_text(const Json& entries) {
    std::string text;
    for (const Json& scene : entries) {
        const auto name = scene["name"].get<std::string>();
        Json parameters = scene["parameters"];
        for (Json& parameter : parameters) parameter["default"] = parameter["default"].dump();  // all digits
        text += wrapped(name + ": " + scene["meaning"].get<std::string>()) + "\n" +
                rows_text(parameters, "parameter = name|#default|unit|meaning") + "\n";
    }
    return text + "A scene file of your own: docs/your_bodies.md; edgewise list scene_files\n";
}

std::string size_text(const Json& bytes) {
    const auto value = bytes.get<std::uint64_t>();
    const bool mib = value % (1 << 20) == 0;
    return mib ? fmt::format("{} MiB", value >> 20)
               : fmt::format("{} KiB", static_cast<double>(value) / 1024);
}

std::string machines_text(const Json& entries) {
    Json rows = entries;
    for (Json& machine : rows)
        for (Json& level : machine["levels"]) level["bytes"] = size_text(level["bytes"]);
    return rows_text(rows,
                     "name|#line = line_bytes|#L1D = levels/0/bytes|#L2 = levels/1/bytes|"
                     "#L3 = levels/2/bytes|#MHz = clock_mhz|#memory = memory/latency_cycles|what") +
           "line in bytes, memory in cycles; ways, latencies and sources: --json, one of which is a machine "
           "file.\nOther machines: --machines mine.json, or from sizes: --machines l2=256K,l3=8M\n";
}

std::string plans_text(const Json& entries) {
    Json rows = entries;
    for (Json& plan : rows) {
        std::map<std::string, int> times;  // a scene may be listed with several parameters
        for (const Json& scene : plan["scenes"])
            ++times[scene.get<std::string>().substr(0, scene.get<std::string>().find(' '))];
        plan["scenes"] = Json::array();
        for (const auto& [name, count] : times)
            plan["scenes"].push_back(count == 1 ? name : fmt::format("{} x {}", name, count));
    }
    return rows_text(rows, "plan = name|#queries|#checked|#rounds|#stability|scenes") +
           "queries per cell and round; of them checked exactly; timed rounds; hard cases per family.\n"
           "Layouts, shapes and parameters: --json\n";
}

std::string layouts_text(const Json& entries) {
    std::string text;
    for (const Json& layout : entries) {
        const auto names = [&](const char* key) {
            return fmt::format("{}", fmt::join(layout[key].get<std::vector<std::string>>(), ", "));
        };
        text += fmt::format("{} ({}; {})\n", layout["name"].get<std::string>(), names("precisions"),
                            names("algorithms"));
        for (const char* key : {"stores", "derives"})
            text += fmt::format("    {}: {}\n", key,
                                wrapped(layout[key].get<std::string>(), widest_line - 13, 13));
    }
    return text;
}

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
    return json_rows(store::vocabulary, [](const store::FigureInfo& figure) {
        return Json{{"name", figure.key},
                    {"unit", figure.unit},
                    {"meaning", figure.meaning},
                    {"population", to_string(figure.population)},
                    {"deterministic", figure.repeats == store::Repeats::exactly}};
    });
}

struct List {
    Json (*entries)();
    const char* columns;                            ///< of its table for people
    std::string (*text)(const Json& entries) = {};  ///< instead of a table
};

const std::map<std::string, List>& lists() {
    static const std::map<std::string, List> known = {
        {"layouts", {list_layouts, "", layouts_text}},
        {"probes", {list_probes, "probe = name|what it measures = summary"}},
        {"algorithms", {list_algorithms, "algorithm = name|needs|what it is = summary"}},
        {"scenes", {list_of_scenes, "", scenes_text}},
        {"shapes", {[] { return Json(scene::list_shapes()); }, "shape = name|#vertices|#edges|#faces"}},
        {"plans", {list_plans, "", plans_text}},
        {"families", {[] { return Json(scene::hard_families()); }, "family = name|varies|breaks"}},
        {"axes", {list_axes, "axis = name|values|meaning"}},
        {"machines", {list_machines, "", machines_text}},
        {"scene_files", {list_scene_files, "scene file = name|what it is for = note"}},
        {"figures", {list_figures, "figure = name|unit|meaning"}}};
    return known;
}

int run_list(const std::string& what, bool as_json) {
    if (!lists().contains(what)) {
        std::vector<std::string> names;
        for (const auto& [name, list] : lists()) names.push_back(name);
        throw std::invalid_argument(unknown_name("list", what, names));
    }
    const List& list = lists().at(what);
    const Json entries = list.entries();
    if (as_json) {
        print_json(Json{{what, entries}});
        return exit_done;
    }
    fmt::print("{}", list.text ? list.text(entries) : rows_text(entries, list.columns));
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
