// SPDX-License-Identifier: MIT
//
// Parses JSON with nlohmann-json and checks its content. Inside, the first fault is thrown as a JsonFault
// and caught once, so that checks read as plain statements.
#include "edgewise/scene/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "edgewise/geometry/message.hpp"
#include "edgewise/input/count.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/input/json_text.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/json_fields.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/scene/scenes.hpp"

namespace edgewise::scene {
namespace {

const std::vector<std::string> members = {"scene", "shapes",  "recording", "time_step",
                                          "needs", "margin",  "sharing",   "parameters",
                                          "vary",  "queries", "note"};

constexpr double usual_time_step = 1.0 / 60;  ///< s: a step per frame of a screen
constexpr double longest_time_step = 1000;    ///< s
constexpr double largest_margin = 1e6;        ///< extents of the larger body

// Each scene takes a file of results and a row in every table, so larger numbers are taken for a mistake.
constexpr std::size_t most_varied = 1000, most_points = 10'000;

// Velocities in the units of scenes, which know steps alone: rad per step, and body sizes per step.
constexpr std::string_view random_turn = "random";  ///< instead of a number

struct MotionUnits {
    double time_step;  ///< s
    double size;       ///< of the body, m
};

/// Returns true if a parameter says how fast bodies turn.
bool is_turn(std::string_view name) { return name == "angular_velocity" || name == "rotation_step"; }

/// A parameter as scenes know it: angular_velocity (rad/s) as rotation_step, linear_velocity (m/s) as
/// translation_step; all others as they are.
std::pair<std::string, double> in_steps(const std::string& name, double value, const MotionUnits& units) {
    if (name == "angular_velocity") return {"rotation_step", value * units.time_step};
    if (name == "linear_velocity") return {"translation_step", value * units.time_step / units.size};
    return {name, value};
}

/// The member as that type, or the standard value when it is absent.
template <class Value>
Value member(const Json& json, const char* key, const Value& standard, const char* wanted) {
    if (!json.contains(key)) return standard;
    try {
        return json.at(key).get<Value>();
    } catch (const Json::exception&) {
        throw JsonFault{fmt::format("{} must be {}", key, wanted)};
    }
}

void check_members(const Json& json) {
    if (!json.is_object())
        throw JsonFault{"the file must be one object: {\"scene\": ..., \"shapes\": [...], ...}"};
    if (const std::string unknown = input::unknown_member(json, "a scene file", members); !unknown.empty())
        throw JsonFault{unknown};
    const bool recorded = json.contains("recording");
    for (const char* key : {"scene", recorded ? "recording" : "shapes"}) {
        if (!json.contains(key)) throw JsonFault{fmt::format("{} is missing", key)};
    }
    if (recorded != (json.at("scene") == recorded_kind))
        throw JsonFault{R"("scene": "recorded" and a "recording" belong together: write both or neither)"};
    for (const char* key : {"shapes", "time_step"})
        if (recorded && json.contains(key))
            throw JsonFault{fmt::format("{} is in the recording: leave it out here", key)};
}

/// The parameters of a point as its kind knows them, each given once: two members of a file that come to the
/// same parameter contradict each other, whichever would win.
class GivenParameters {
  public:
    explicit GivenParameters(const MotionUnits& units) : units_(units) {}

    /// `where` it was written, such as "vary.rotation_step".
    void set(const std::string& where, const std::string& name, const Json& value) {
        if (value.is_string() && value.get<std::string>() == random_turn && is_turn(name)) {
            take(where, "random_orientation", 1);
            take(where, "rotation_step", 0);
            return;
        }
        if (!value.is_number())
            throw JsonFault{fmt::format("{} = {} must be a number{}", name, value.dump(),
                                        is_turn(name) ? " or \"random\"" : "")};
        const auto [parameter, number] = in_steps(name, value.get<double>(), units_);
        take(where, parameter, number);
    }
    void take(const std::string& where, const std::string& parameter, double number) {
        const auto [first, is_new] = places_.try_emplace(parameter, where);
        if (!is_new)
            throw JsonFault{fmt::format("{} and {} both say what {} is: leave one of them out", first->second,
                                        where, parameter)};
        values_[parameter] = number;
    }
    [[nodiscard]] const SceneParameters& values() const { return values_; }

  private:
    MotionUnits units_;
    SceneParameters values_;
    std::map<std::string, std::string> places_;  ///< where each was written
};

const Json& object_at(const Json& json, const char* key) {
    static const Json empty = Json::object();
    if (!json.contains(key)) return empty;
    if (!json.at(key).is_object())
        throw JsonFault{fmt::format("{} must be an object of numbers by name", key)};
    return json.at(key);
}

/// The varied parameter and its values; nothing where none is.
std::vector<std::pair<std::string, Json>> varied(const Json& json) {
    std::vector<std::pair<std::string, Json>> values;
    const Json& vary = object_at(json, "vary");
    if (vary.size() > 1) throw JsonFault{"vary takes one parameter; write one file for each parameter"};
    for (const auto& [name, list] : vary.items()) {
        if (!list.is_array() || list.empty())
            throw JsonFault{fmt::format("vary.{} must be a list of values", name)};
        if (list.size() > most_varied)
            throw JsonFault{fmt::format("vary.{} has {} values, more than the {} of one file", name,
                                        list.size(), most_varied)};
        for (const Json& value : list) {
            if (std::ranges::find(values, value, &std::pair<std::string, Json>::second) != values.end())
                throw JsonFault{
                    fmt::format("vary.{} has {} twice: leave one of them out", name, value.dump())};
            values.emplace_back(name, value);
        }
    }
    return values;
}

ScenePoint make_point(const Json& json, const SceneFile& file, const NamedShape& shape,
                      const std::pair<std::string, Json>* varied_value) {
    GivenParameters given({file.time_step, extent(shape.body.vertices)});
    if (member<std::string>(json, "sharing", "shared", "shared or per_instance") == "per_instance")
        given.take("sharing", "own_tables", 1);
    if (file.recording) given.take("recording", "recording", file.recording->checksum);
    for (const auto& [name, value] : object_at(json, "parameters").items())
        given.set("parameters." + name, name, value);
    if (varied_value) given.set("vary." + varied_value->first, varied_value->first, varied_value->second);
    const SceneParameters& values = given.values();
    if (file.recording && file.recording->has_pairs && values.contains("margin") &&
        (!values.contains("own_pairs") || values.at("own_pairs") == 0))
        throw JsonFault{"margin is for pairs that are not the engine's: write own_pairs = 1 too"};
    const auto complete = complete_parameters(file.kind, values);
    if (!complete) throw JsonFault{complete.error};
    return {shape.name, *complete};
}

/// Built-in bodies, and bodies of mesh files in the scene file's folder.
std::vector<NamedShape> shapes_of(const Json& json, const SceneFileContext& context, std::string& warning) {
    std::vector<NamedShape> shapes;
    for (const auto& name :
         member<std::vector<std::string>>(json, "shapes", {}, "a list of shapes' names and mesh files")) {
        auto shape = named_shape(names_mesh_file(name) ? (context.folder / name).string() : name,
                                 {.as_stored = context.as_stored});
        if (!shape) throw JsonFault{"shapes: " + shape.error};
        add_warning(warning, shape.warning);
        shapes.push_back(*std::move(shape));
    }
    if (shapes.empty()) throw JsonFault{"shapes needs at least one name"};
    if (const std::string twice = shape_given_twice(shapes); !twice.empty())
        throw JsonFault{"shapes: " + twice};
    return shapes;
}

/// Reads the recording; the scene's shape is its first core.
void take_recording(const Json& json, const SceneFileContext& context, SceneFile& file) {
    if (!context.bodies.empty()) throw JsonFault{"a recording has its own bodies: name none with --shape"};
    const auto path = context.folder / member<std::string>(json, "recording", "", "a file");
    auto read = read_recording(path.string(), context.as_stored);
    if (!read) throw JsonFault{"recording: " + read.error};
    file.recording = std::make_shared<const Recording>(*std::move(read.value));
    const Recording& recording = *file.recording;
    file.shapes = {{recording.name,
                    fmt::format("{} bodies with {} cores, recorded ({:08x})", recording.bodies.size(),
                                recording.cores.size(), recording.checksum),
                    recording.cores.front(),
                    {}}};
}

void add_points(const Json& json, SceneFile& file) {
    const auto values = varied(json);
    if (const std::size_t points = values.size() * file.shapes.size(); points > most_points)
        throw JsonFault{
            fmt::format("{} shapes with {} values each are {} scenes, more than the {} of one file",
                        file.shapes.size(), values.size(), points, most_points)};
    for (const NamedShape& shape : file.shapes) {
        if (values.empty()) file.points.push_back(make_point(json, file, shape, nullptr));
        for (const auto& value : values) file.points.push_back(make_point(json, file, shape, &value));
    }
}

Needs needs_of(const Json& json) {
    const auto name = member<std::string>(json, "needs", "witnesses", "one of the needs' names");
    const auto needs = needs_from(name);
    if (!needs) throw JsonFault{unknown_name("needs", name, {needs_names.begin(), needs_names.end()})};
    return *needs;
}

/// Margin for needs that have one; 0 if none is given.
double margin_of(const Json& json, Needs needs) {
    if (!json.contains("margin")) return 0;
    if (!has_margin(needs))
        throw JsonFault{"margin is only for needs = nearer or within: leave it out, or write both"};
    const auto margin = member<double>(json, "margin", 0, "a number");
    if (!(margin > 0 && margin <= largest_margin))
        throw JsonFault{fmt::format("margin = {} is out of bounds; choose above 0, to {:.0f} extents", margin,
                                    largest_margin)};
    return margin;
}

SceneFile read(const std::string& name, const Json& json, const SceneFileContext& context,
               std::string& warning) {
    check_members(json);
    SceneFile file;
    file.name = name;
    file.text = json.dump(-1, ' ', false, Json::error_handler_t::replace);  // a file's name may be no UTF-8
    file.kind = member<std::string>(json, "scene", "", "the name of a scene");
    if (json.contains("recording"))
        take_recording(json, context, file);
    else
        file.shapes = context.bodies.empty() ? shapes_of(json, context, warning) : context.bodies;
    file.time_step = member(json, "time_step", usual_time_step, "a number of seconds");
    if (!(file.time_step > 0 && file.time_step <= longest_time_step))
        throw JsonFault{fmt::format("time_step = {} is out of bounds; choose above 0, to {} s",
                                    file.time_step, longest_time_step)};
    file.needs = needs_of(json);
    file.margin = margin_of(json, file.needs);
    const auto sharing = member<std::string>(json, "sharing", "shared", "shared or per_instance");
    if (sharing != "shared" && sharing != "per_instance")
        throw JsonFault{unknown_name("sharing", sharing, {"shared", "per_instance"})};
    const auto queries = input::count_from(json.value("queries", Json(0U)), input::queries_or_none);
    if (!queries) throw JsonFault{"queries = " + queries.error};
    file.queries = *queries;
    file.note = member<std::string>(json, "note", "", "a text");
    add_points(json, file);
    return file;
}

Result<SceneFile> read_checked(const std::string& name, const Json& json, const SceneFileContext& context) {
    try {
        std::string warning;
        SceneFile file = read(name, json, context, warning);
        return Result<SceneFile>::success(std::move(file), warning);
    } catch (const JsonFault& fault) {
        return Result<SceneFile>::failure(
            fmt::format("scene file {}: {}", name, without_controls(fault.what)));
    }
}

}  // namespace

std::string shape_given_twice(std::span<const NamedShape> shapes) {
    std::map<std::string_view, const NamedShape*> known;
    for (const NamedShape& shape : shapes) {
        const auto [first, is_new] = known.emplace(shape.name, &shape);
        if (is_new) continue;
        if (first->second->source == shape.source)
            return fmt::format("'{}' ({}) is given twice: leave one out, or rename it", shape.name,
                               shape.source);
        return fmt::format("two bodies are called '{}' ({} and {}): rename one", shape.name,
                           first->second->source, shape.source);
    }
    return {};
}

Result<SceneFile> parse_scene_file(const std::string& name, const std::string& text,
                                   const SceneFileContext& context) {
    const auto json = input::parse_json(text);
    if (json) return read_checked(name, *json, context);
    return Result<SceneFile>::failure(fmt::format("scene file {}: {}", name, json.error));
}

Result<SceneFile> read_scene_file(const std::string& path, SceneFileContext context) {
    const std::filesystem::path file = path;
    context.folder = file.parent_path();
    if (names_recording(path)) {
        const Json json = {{"scene", recorded_kind}, {"recording", file.filename().string()}};
        return read_checked(scene_name_at(file), json, context);
    }
    const auto text = input::read_file_text(path);
    if (!text) return Result<SceneFile>::failure("scene file " + text.error);
    return parse_scene_file(scene_name_at(file), *text, context);
}

std::string scene_name_at(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    return names_recording(name) ? name.substr(0, name.find(".jsonl")) : file.stem().string();
}

bool is_scene_file(const std::string& name_or_path) {
    return name_or_path.ends_with(".json") || names_recording(name_or_path) ||
           std::ranges::find(scene_texts(), std::string_view(name_or_path), &SceneText::name) !=
               scene_texts().end();
}

std::optional<Result<SceneFile>> find_scene_file(const std::string& name_or_path,
                                                 const SceneFileContext& context) {
    for (const SceneText& text : scene_texts()) {
        if (text.name == name_or_path) return parse_scene_file(name_or_path, std::string(text.json), context);
    }
    if (is_scene_file(name_or_path)) return read_scene_file(name_or_path, context);
    return std::nullopt;
}

}  // namespace edgewise::scene
