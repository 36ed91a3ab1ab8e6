// SPDX-License-Identifier: MIT
#include "edgewise/cli/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "edgewise/input/known_names.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/machine/quietness.hpp"
#include "edgewise/reports/compare/comparison.hpp"
#include "edgewise/scene/recording.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::cli {

namespace {

/// Takes what is odd about a file to stderr, and returns the body or throws.
template <class Body>
Body with_warning(Result<Body> body) {
    if (!body.warning.empty()) warn(body.warning);
    return std::move(body).or_throw();
}

CLI::Option* add_as_stored_option(CLI::App& command, bool& as_stored) {
    return command.add_flag("--as-stored", as_stored,
                            "leave out the turn and the scale that a COLLADA file names (up axis, unit)");
}

constexpr const char* shape_type = "NAME|FILE";

}  // namespace

void take_parameter(const std::string& text, scene::SceneParameters& parameters, const char* option) {
    const std::size_t equals = text.find('=');
    const auto number = equals == std::string::npos ? Result<double>::failure("no =")
                                                    : input::parse_number(text.substr(equals + 1));
    if (!number)
        throw CLI::ValidationError(fmt::format("{} {}: {}; write NAME=NUMBER", option, text, number.error));
    if (!parameters.try_emplace(text.substr(0, equals), *number).second)
        throw CLI::ValidationError(fmt::format("{} {}: given twice: leave one out", option, text));
}

CLI::Option* add_names(CLI::App& command, const char* option, std::vector<std::string>& to,
                       const char* what) {
    return command.add_option(option, to, what)->delimiter(',');
}

CLI::Option* add_table_option(CLI::App& command, std::string& table, const char* names) {
    return command.add_option(names, table, "one table type (edgewise list layouts)")->capture_default_str();
}

CLI::Option* add_layouts_option(CLI::App& command, std::vector<std::string>& layouts) {
    return add_names(command, "--layouts", layouts, "only these layouts or table types, such as aos,soa_f32");
}

CLI::Option* add_algorithm_option(CLI::App& command, std::string& algorithm) {
    return command.add_option("--algorithm", algorithm, "vclip or gjk")->capture_default_str();
}

CLI::Option* add_algorithms_option(CLI::App& command, std::vector<std::string>& algorithms) {
    return add_names(command, "--algorithms", algorithms, "only these algorithms");
}

CLI::Option* add_wait_option(CLI::App& command, bool& waits) {
    return command.add_flag("--wait", waits, "wait up to a minute for a busy machine to become quiet");
}

void say_how_quiet(bool waits, bool json) {
    constexpr double longest_wait = 60;
    const measure::Stopwatch watch;
    measure::Quietness now = measure::look_at_quietness();
    while (waits && !now.is_quiet() && watch.elapsed_ns() < 1e9 * longest_wait && !stop_on_signals()) {
        std::this_thread::sleep_for(std::chrono::seconds(1));
        now = measure::look_at_quietness();
    }
    if (json) return;
    fmt::print(stderr, "machine: others take {:.0f} % of this processor, fixed work varies by {:.0f} %: {}\n",
               100 * now.others, 100 * now.scatter,
               now.is_quiet() ? "quiet"
               : waits        ? "busy, also after a minute; times will scatter"
                              : "busy; times will scatter; end other work, or use --wait");
}

CLI::Option* add_peers_option(CLI::App& command, std::vector<std::string>& peers) {
    return add_names(command, "--peers", peers, "these other libraries too; all: every one that is built");
}

CLI::Option* add_machines_option(CLI::App& command, std::vector<std::string>& machines) {
    return add_names(command, "--machines,--machine", machines,
                     "machines to model the caches of: a name (edgewise list machines), host for this "
                     "machine, your own NAME.json, or cache sizes such as l2=256K,l3=8M");
}

CLI::Option* add_families_option(CLI::App& command, std::vector<std::string>& families) {
    return add_names(command, "--families", families,
                     "only these families of pairs (edgewise list families)");
}

CLI::Option* add_read_store_option(CLI::App& command, std::string& store) {
    return command.add_option("store,--store", store, "store (an SQLite file): read")->capture_default_str();
}

CLI::Option* add_store_option(CLI::App& command, std::string& store, const std::string& what) {
    return command.add_option("--store", store, "store (an SQLite file): " + what);
}

void add_format_option(CLI::App& command, std::string& format) {
    command.add_option("--format", format, "the format of what is printed")
        ->check(
            CLI::IsMember({reports::ci_markdown, reports::ci_github, reports::ci_bencher, reports::ci_junit}))
        ->excludes(command.get_option("--json"));
}

int print_comparison(const measure::RecordComparison& found, const std::string& old_name, bool json,
                     const std::string& format, const std::string& before) {
    const std::string text = json             ? to_json(found)
                             : format.empty() ? before + to_text(found, old_name)
                                              : reports::ci_text(found, format, old_name);
    fmt::print("{}", json ? text : input::shown_text(text));
    return found.exit_code();
}

CLI::Option* add_svg_option(CLI::App& command, std::string& file) {
    return add_output_file(command, "--svg", file, "file to write: the picture as SVG");
}

namespace {

/// Finds a mesh file that a report names without its folder among those that plans bring with them.
std::string found_mesh(const std::string& name) {
    if (!scene::names_mesh_file(name) || std::filesystem::exists(name)) return name;
    const std::string own = sweep::file_beside_builds("meshes", name);
    return std::filesystem::exists(own) ? own : name;
}

}  // namespace

CLI::Option* add_shape_option(CLI::App& command, std::string& shape, bool& as_stored, const char* names) {
    if (!command.get_option_no_throw("--as-stored")) add_as_stored_option(command, as_stored);
    return command.add_option(names, shape, "body: built in (edgewise list shapes), or a mesh file")
        ->transform(found_mesh)
        ->type_name(shape_type)
        ->capture_default_str();
}

CLI::Option* add_shapes_option(CLI::App& command, std::vector<std::string>& shapes, bool& as_stored) {
    add_as_stored_option(command, as_stored);
    return add_names(command, "--shape,--shapes,--mesh", shapes,
                     "only these bodies: built in (edgewise list shapes), or mesh files")
        ->transform(found_mesh)
        ->type_name(shape_type);
}

void take_bodies(const std::vector<std::string>& shapes, sweep::Plan& plan) {
    plan.shapes.clear();
    plan.meshes.clear();
    for (const std::string& name : shapes)
        (scene::names_mesh_file(name) ? plan.meshes : plan.shapes).push_back(name);
    plan.meshes_required = true;
}

std::string bodies_of(const studies::CellChoice& choice) {
    return scene::names_recording(choice.scene) ? "its own bodies" : choice.shape;
}

scene::MeshBody chosen_body(const BodyChoice& choice, bool takes_flat) {
    scene::refuse_as_stored_without_mesh(choice.as_stored, {&choice.shape, 1});
    if (!scene::names_mesh_file(choice.shape)) {
        Polyhedron body = scene::make_shape(choice.shape).or_throw();
        return {choice.shape, body, body.vertices};
    }
    return std::move(
        with_warning(scene::read_mesh_file(choice.shape, {false, choice.as_stored, takes_flat})).front());
}

scene::NamedShape chosen_shape(const BodyChoice& choice) {
    scene::refuse_as_stored_without_mesh(choice.as_stored, {&choice.shape, 1});
    return with_warning(scene::named_shape(choice.shape, {.as_stored = choice.as_stored}));
}

CLI::Option* add_parameter_option(CLI::App& command, scene::SceneParameters& parameters) {
    return command
        .add_option_function<std::vector<std::string>>(
            "--parameter",
            [&parameters](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) take_parameter(text, parameters);
            },
            "parameters of the scene")
        ->type_name("NAME=NUMBER");
}

void add_needs_option(CLI::App& command, std::function<void(Needs)> take, Needs usual) {
    command
        .add_option_function<std::string>(
            "--needs",
            [take = std::move(take)](const std::string& name) {
                const auto needs = needs_from(name);
                if (!needs)
                    throw CLI::ValidationError(
                        "--needs: " + unknown_name("need", name, {needs_names.begin(), needs_names.end()}));
                take(*needs);
            },
            fmt::format("what is asked of every answer: {}", fmt::join(needs_names, ", ")))
        ->default_str(std::string(to_string(usual)));
}

void add_sub_distance_option(CLI::App& command, SubDistanceSolver& solver) {
    const std::string known = fmt::format("{}", fmt::join(sub_distance_solver_names, ", "));
    command.add_option_function<std::string>(
        "--sub-distance",
        [&solver, known](const std::string& name) {
            const auto named = sub_distance_solver_from(name);
            if (!named)
                throw CLI::ValidationError(
                    "--sub-distance: " +
                    unknown_name("solver", name,
                                 {sub_distance_solver_names.begin(), sub_distance_solver_names.end()}));
            solver = *named;
        },
        fmt::format("how GJK solves its simplices: {} [{}]", known, to_string(solver)));
}

void add_margin_option(CLI::App& command, std::optional<double>& margin) {
    add_number(
        command, "--margin", margin, input::above_0,
        fmt::format(
            "the distance that --needs nearer and within ask about, divided by the larger body's extent "
            "(else {})",
            bench::usual_margin));
}

CLI::Option* add_scene_option(CLI::App& command, std::string& scene) {
    return command.add_option("--scene", scene, "scene: a kind (edgewise list scenes), or a recording")
        ->capture_default_str();
}

void refuse_recordings(CLI::App& command) {
    command.get_option("--scene")
        ->description("scene: a kind (edgewise list scenes)")
        ->check([](const std::string& scene) {
            return scene::names_recording(scene)
                       ? fmt::format("{} is a recording: edgewise sweep --scenes {} measures it", scene,
                                     scene)
                       : std::string();
        });
}

void add_cell_options(CLI::App& command, studies::CellChoice& choice) {
    add_table_option(command, choice.table);
    add_algorithm_option(command, choice.algorithm);
    add_scene_options(command, choice);
}

void add_scene_options(CLI::App& command, studies::CellChoice& choice) {
    choice.warn = warn;
    add_scene_option(command, choice.scene);
    add_shape_option(command, choice.shape, choice.as_stored);
    add_queries_option(command, choice.queries);
    add_seed_option(command, choice.seed);
    add_parameter_option(command, choice.parameters);
    add_needs_option(
        command, [&choice](Needs needs) { choice.needs = needs; }, choice.needs);
    add_margin_option(command, choice.margin);
    add_sub_distance_option(command, choice.sub_distance);
}

void add_shard_option(CLI::App& command, std::string& shard) {
    command.add_option("--shard", shard,
                       "this part of it alone: i/n, from 0/n on; auto or auto/n: the part that a scheduler's "
                       "environment says");
}

void add_shard_options(CLI::App& command, std::string& shard, std::string& costs) {
    add_shard_option(command, shard);
    command
        .add_option("--costs", costs,
                    "store of an earlier run, whose seconds make parts even; the same for all")
        ->needs(command.get_option("--shard"));
}

sweep::Shard chosen_shard(const std::string& text) {
    if (text.empty()) return {};
    return sweep::parse_shard(text, [](const char* name) -> const char* { return std::getenv(name); })
        .or_throw();
}

namespace fs = std::filesystem;

namespace {

/// "out/" is "out".
fs::path named_folder(const std::string& folder) {
    const fs::path path = fs::path(folder).lexically_normal();
    return path.has_filename() ? path : path.parent_path();
}

bool is_usual(const std::string& folder) { return folder == folder_of(default_store); }

}  // namespace

CLI::Option* add_output_file(CLI::App& command, const std::string& name, std::string& to,
                             const std::string& what) {
    const auto is_fit = [](const std::string& path) -> std::string {
        try {
            static_cast<void>(input::output_place(path));
            return {};
        } catch (const std::exception& problem) {
            return problem.what();
        }
    };
    return command.add_option(name, to, what)->type_name("FILE")->check(CLI::Validator(is_fit, ""));
}

void check_folder(const std::string& folder, const std::string& option) {
    const fs::path named = named_folder(folder), above = named.parent_path();
    if (fs::is_directory(named)) return;
    if (!above.empty() && !fs::is_directory(above))
        throw std::invalid_argument(fmt::format("{} {}: there is no folder {}; make it, or correct the path",
                                                option, folder, above.string()));
}

void check_folder_of(const std::string& file, const std::string& option) {
    if (!is_usual(folder_of(file))) check_folder(folder_of(file), option);
}

void make_folder(const std::string& folder, const std::string& option) {
    check_folder(folder, option);
    std::error_code failed;
    fs::create_directory(named_folder(folder), failed);
    if (failed)
        throw std::invalid_argument(
            fmt::format("{} {}: the folder cannot be made: {}", option, folder, failed.message()));
}

void make_folder_of(const std::string& file, const std::string& option) {
    const std::string folder = folder_of(file);
    if (is_usual(folder)) fs::create_directories(folder);
    make_folder(folder, option);
}

}  // namespace edgewise::cli
