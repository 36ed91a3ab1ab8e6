// SPDX-License-Identifier: MIT
#include "edgewise/sweep/work.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <map>
#include <stdexcept>

#include "edgewise/bench/cell.hpp"
#include "edgewise/bench/peers/peer_modules.hpp"
#include "edgewise/bench/probe.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/sweep/study.hpp"

namespace edgewise::sweep {

namespace {

void add_mesh(const Plan& plan, const std::string& file, std::vector<scene::NamedShape>& to,
              const std::function<void(const std::string&)>& warn) {
    auto shapes = scene::mesh_shapes(file, {plan.each_mesh, plan.as_stored});
    if (shapes) {
        // The report gives the warnings of the plan's own bodies. Those of a user's bodies are also printed.
        if (!shapes.warning.empty() && plan.meshes_required) warn(shapes.warning);
        std::ranges::move(*shapes, std::back_inserter(to));
        return;
    }
    if (plan.meshes_required) throw std::invalid_argument(shapes.error);
    warn(shapes.error);
    const std::filesystem::path path = file;
    to.push_back({path.stem().string(), path.filename().string(), {}, shapes.error});
}

template <class Names>
bool allows(const Names& names, const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// Throws unless both are known.
void check_pair(const std::string& pair) {
    const std::size_t blank = pair.find(' ');
    if (blank == pair.npos)
        throw std::invalid_argument(fmt::format("pairs: '{}' is not an algorithm and a layout", pair));
    static_cast<void>(bench::select_algorithms(std::vector<std::string>{pair.substr(0, blank)}));
    static_cast<void>(bench::select_table_types(std::vector<std::string>{pair.substr(blank + 1)}));
}

/// A misspelt name would leave a scene without cells in silence. Names of bodies that are not in the plan are
/// right as long as there is such a body.
void check_names(const SceneChoice& choice, const std::vector<const scene::NamedShape*>& found) {
    if (!choice.algorithms.empty()) static_cast<void>(bench::select_algorithms(choice.algorithms));
    for (const std::string& pair : choice.pairs) check_pair(pair);
    std::vector<std::string> names = choice.shapes;
    for (const std::string& name : choice.caches) {
        if (name != "all") names.push_back(name);
    }
    for (const std::string& name : names) {
        if (std::ranges::find(found, name, &scene::NamedShape::name) != found.end()) continue;
        static_cast<void>(scene::make_shape(name).or_throw());
    }
}

void check_probes(const std::vector<std::string>& wanted) {
    std::vector<std::string> known;
    for (const bench::Probe& probe : bench::registered_probes()) known.emplace_back(probe.name);
    for (const std::string& name : wanted) {
        if (std::ranges::find(known, name) == known.end())
            throw std::invalid_argument(unknown_name("probe", name, known));
    }
}

/// The plain cell, then the scene's own axes or the plan's.
std::vector<Axes> axes_of(const SceneChoice& choice, const Plan& plan) {
    std::vector<Axes> all(1);
    if (choice.plain) return all;
    for (const std::string& text : choice.axes.empty() ? plan.axes : choice.axes)
        all.push_back(parse_axes(text));
    return all;
}

/// Returns the work of a scene without its shapes and parameters.
SceneWork unplaced_work(const SceneChoice& choice, const SweepWork& work) {
    SceneWork scene;
    scene.choice = choice;
    scene.queries = choice.queries > 0 ? choice.queries : work.plan.queries;
    scene.types = work.types;
    scene.axes = axes_of(choice, work.plan);
    for (const std::string& algorithm : work.algorithms) {
        if (allows(choice.algorithms, algorithm)) scene.algorithms.push_back(algorithm);
    }
    return scene;
}

/// Returns the work of a scene, with the plan's shapes and table types that the scene names.
SceneWork scene_work(const SceneChoice& choice, const SweepWork& work) {
    SceneWork scene = unplaced_work(choice, work);
    scene.choice.parameters = scene::complete_parameters(choice.name, choice.parameters).or_throw();
    for (const scene::NamedShape& shape : work.shapes) {
        if (allows(choice.shapes, shape.name)) scene.shapes.push_back(&shape);
    }
    check_names(choice, scene.shapes);
    if (choice.layouts.empty()) return scene;
    const std::vector<const bench::TableType*> wanted = bench::select_table_types(choice.layouts);
    std::erase_if(scene.types, [&](const auto* type) { return std::ranges::count(wanted, type) == 0; });
    return scene;
}

/// Keeps the shape at a stable address. A shape with the same name and source is kept only once.
const scene::NamedShape* kept_shape(const scene::NamedShape& shape, SweepWork& work) {
    for (const scene::NamedShape& known : work.file_shapes) {
        if (known.name == shape.name && known.source == shape.source) return &known;
    }
    return &work.file_shapes.emplace_back(shape);
}

/// Adds one scene for each point of the file.
void add_scene_file(const scene::SceneFile& file, const SceneChoice& choice, SweepWork& work) {
    std::vector<const scene::NamedShape*> bodies;
    for (const scene::NamedShape& shape : file.shapes) bodies.push_back(&shape);
    for (const scene::NamedShape& shape : work.shapes) bodies.push_back(&shape);
    check_names(choice, bodies);
    SceneWork scene = unplaced_work(choice, work);
    scene.choice.name = file.name;
    scene.kind = file.kind;
    scene.json = file.text;
    scene.path = choice.name;
    scene.choice.recording = file.recording;
    if (file.queries > 0 && choice.queries == 0) scene.queries = file.queries;
    if (!choice.layouts.empty()) scene.types = bench::select_table_types(choice.layouts);
    for (Axes& axes : scene.axes) {
        if (axes.needs != Needs::witnesses) continue;
        axes.set_needs(file.needs);
        if (file.margin > 0) axes.margin = file.margin;
        axes = parse_axes(axes.text());  // refuses axes that do not go with the file's needs
    }
    for (const scene::ScenePoint& point : file.points) {
        if (!allows(choice.shapes, point.shape)) continue;
        scene.choice.parameters = point.parameters;
        const auto shape = std::ranges::find(file.shapes, point.shape, &scene::NamedShape::name);
        scene.shapes = {kept_shape(*shape, work)};
        work.scenes.push_back(scene);
    }
}

/// Adds the points of the scene file if the choice is one. Returns true if it is.
bool add_if_file(const SceneChoice& choice, SweepWork& work,
                 const std::function<void(const std::string&)>& warn) {
    if (!scene::is_scene_file(choice.name)) return false;
    // A plan names recordings that layouts/sweep makes.
    const std::string made = file_beside_builds("recordings", choice.name);
    const bool is_missing = scene::names_recording(choice.name) && !std::filesystem::exists(choice.name);
    const bool takes_made = is_missing && std::filesystem::exists(made);
    if (is_missing && !takes_made && choice.optional) {
        warn(
            fmt::format("scene {} is left out: there is no such recording; layouts/sweep makes it where "
                        "its engine is installed",
                        choice.name));
        return true;
    }
    auto file = scene::find_scene_file(
        takes_made ? made : choice.name,
        {.bodies = work.plan.bodies_for_files ? work.shapes : std::vector<scene::NamedShape>{},
         .as_stored = work.plan.as_stored});
    if (!file->warning.empty()) warn(file->warning);
    if (!choice.parameters.empty())
        throw std::invalid_argument("scene file " + choice.name + ": its parameters are in the file");
    add_scene_file(std::move(*file).or_throw(), choice, work);
    return true;
}

/// Libraries are asked for distances, verdicts alone, and of rounded bodies, which takes their distances.
bool is_asked(const bench::TableType& peer, Axes axes) {
    if (peer.verdict_only && axes.has_radius()) return false;
    axes.radius = 0;
    axes.recorded_radii = false;
    return axes.text().empty() || axes.text() == "needs=verdict";
}

}  // namespace

bool SceneWork::models_caches(const scene::NamedShape& shape) const {
    return std::any_of(choice.caches.begin(), choice.caches.end(),
                       [&](const std::string& name) { return name == "all" || name == shape.name; });
}

std::string comparison_name(const SceneWork& scene, const scene::NamedShape& shape) {
    return scene.choice.name + " " + bench::parameters_json(scene.choice.parameters) + " " + shape.name;
}

std::size_t SweepWork::cells() const {
    std::size_t count = 0;
    for (const SceneWork& scene : scenes) {
        each_cell(scene, [&](const bench::TableType&, const std::string&, const Axes&) {
            count += scene.shapes.size();
        });
    }
    return count;
}

void SweepWork::each_cell(const SceneWork& scene,
                          const std::function<void(const bench::TableType&, const std::string& algorithm,
                                                   const Axes&)>& use) const {
    for (const bench::TableType* type : scene.types) {
        for (const std::string& algorithm : scene.algorithms) {
            if (!type->serves(algorithm) || !(allows(scene.choice.pairs, algorithm + " " + type->name) ||
                                              allows(scene.choice.pairs, algorithm + " " + type->layout)))
                continue;
            for (std::size_t i = 0; i < scene.axes.size(); ++i) {
                const Axes& axes = scene.axes[i];
                if (i > 0 && !axes.concerns(algorithm)) continue;
                if (axes.default_build && !bench::has_default_build(*type, algorithm)) continue;
                use(*type, algorithm, axes);
            }
        }
    }
    for (const bench::TableType* peer : peers)
        for (const Axes& axes : scene.axes)
            if (&axes == &scene.axes.front() || is_asked(*peer, axes))
                use(*peer, peer->algorithms.front(), axes);
}

std::vector<scene::NamedShape> shapes_of(const Plan& plan,
                                         const std::function<void(const std::string&)>& warn) {
    std::vector<scene::NamedShape> result;
    for (const std::string& name : plan.shapes)
        result.push_back({name, "built-in", scene::make_shape(name).or_throw(), {}});
    for (const std::string& file : plan.meshes) add_mesh(plan, file, result, warn);
    if (const std::string twice = scene::shape_given_twice(result); !twice.empty())
        throw std::invalid_argument(twice);
    return result;
}

namespace {

/// Returns true if a study of the plan measures its bodies.
bool a_study_takes_bodies(const Plan& plan) {
    return std::ranges::any_of(registered_studies(), [&](const Study& study) {
        return study.of_bodies && plan.count_of(study.name) > 0;
    });
}

/// Mesh files are read, and warned about, where some scene or study is of them. One body for each mesh of a
/// file has a name that only the file knows.
Plan without_unused_meshes(Plan plan) {
    if (plan.each_mesh || plan.meshes_required || a_study_takes_bodies(plan)) return plan;
    std::erase_if(plan.meshes, [&](const std::string& file) {
        const std::string name = std::filesystem::path(file).stem().string();
        return std::none_of(plan.scenes.begin(), plan.scenes.end(), [&](const SceneChoice& scene) {
            return allows(scene.shapes, name) && !scene::is_scene_file(scene.name);
        });
    });
    return plan;
}

}  // namespace

SweepWork prepare_sweep(const Plan& plan, const std::function<void(const std::string& line)>& warn) {
    SweepWork work;
    work.plan = plan;
    work.types = bench::select_table_types(plan.layouts);
    work.peers = bench::select_peer_types(plan.peers);
    work.algorithms = bench::select_algorithms(plan.algorithms);
    work.machines = measure::choose_machines(plan.machines);
    check_scene_names(plan);
    check_probes(plan.probes);
    for (const SceneChoice& scene : plan.scenes) {
        if (!scene::is_scene_file(scene.name))
            static_cast<void>(scene::complete_parameters(scene.name, scene.parameters).or_throw());
    }
    // Bodies that nothing is of are not read, and nothing is said of them.
    const auto takes_bodies = [&](const SceneChoice& scene) {
        return plan.bodies_for_files || a_study_takes_bodies(plan) || !scene::is_scene_file(scene.name);
    };
    if (std::ranges::any_of(plan.scenes, takes_bodies))
        work.shapes = shapes_of(without_unused_meshes(plan), warn);
    for (const SceneChoice& scene : plan.scenes) {
        if (!add_if_file(scene, work, warn)) work.scenes.push_back(scene_work(scene, work));
    }
    if (work.cells() == 0) {
        throw std::invalid_argument(
            "this plan has no cells: no layout serves the algorithms chosen, or no shape or scene is left");
    }
    return work;
}

namespace {

/// Returns the name of a scene's files and charts: letters, digits, _ and -.
std::string scene_id(std::string name) {
    std::ranges::replace_if(
        name, [](unsigned char c) { return !std::isalnum(c) && c != '_' && c != '-'; }, '_');
    return name;
}

/// Returns what has this name, if a user's scene file may not use it; otherwise empty.
std::string owner_of_scene_name(const std::string& name) {
    const std::string id = scene_id(name);
    for (const scene::SceneInfo& kind : scene::list_scenes()) {
        if (id == kind.name) return fmt::format("the kind of scene '{}'", kind.name);
    }
    for (const scene::SceneText& text : scene::scene_texts()) {
        if (id == text.name) return fmt::format("the scene file '{}' that comes along", text.name);
    }
    return {};
}

}  // namespace

void check_scene_names(const Plan& plan) {
    const auto texts = scene::scene_texts();
    std::map<std::string, std::string> paths;  // by id
    for (const SceneChoice& scene : plan.scenes) {
        if (!scene::is_scene_file(scene.name) ||
            std::ranges::find(texts, scene.name, &scene::SceneText::name) != texts.end())
            continue;
        const std::string name = scene::scene_name_at(scene.name);
        if (const std::string owner = owner_of_scene_name(name); !owner.empty())
            throw std::invalid_argument(
                fmt::format("scene file {}: its name is that of {}: rename the file", scene.name, owner));
        const auto [first, is_new] = paths.try_emplace(scene_id(name), scene.name);
        std::error_code error;
        if (!is_new && first->second != scene.name &&
            !std::filesystem::equivalent(first->second, scene.name, error))
            throw std::invalid_argument(
                fmt::format("scene files {} and {} would go by one name, '{}': rename one", first->second,
                            scene.name, first->first));
    }
}

void check_scene_files(const SweepWork& work, const store::Store& store) {
    for (const SceneWork& scene : work.scenes) {
        const auto stored = store.meta(store::scene_file_key + scene.choice.name);
        if (scene.json.empty() || !stored || *stored == scene.json) continue;
        const std::string earlier =
            store.meta(store::scene_path_key + scene.choice.name).value_or("an earlier run's file");
        throw std::invalid_argument(fmt::format(
            "scene file {}: the store holds a different scene of this name, '{}', from {}: rename "
            "the file or name another store",
            scene.path, scene.choice.name, earlier));
    }
}

}  // namespace edgewise::sweep
