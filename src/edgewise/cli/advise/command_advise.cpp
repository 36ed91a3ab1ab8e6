// SPDX-License-Identifier: MIT
//
// `edgewise advise`: which layout to take for a case of the user's, measured in less than a minute: every
// cell looked at, the best raced in several processes, the caches of the asked machine modelled; how sure
// that is, and what would change it.
#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/cli/command.hpp"
#include "edgewise/geometry/known_names.hpp"
#include "edgewise/reports/answer/answer_json.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/scene/mesh/mesh_shapes.hpp"
#include "edgewise/scene/scene_file.hpp"

namespace edgewise::cli {

namespace {

struct AdviseArguments {
    std::vector<std::string> meshes, machines;
    std::string scene, store, needs = "distance";
    std::optional<std::size_t> bodies, vertices;
    std::optional<double> turn;
    bool own = false, shared = false;
    double error = 1e-6, seconds = 45;
    std::uint64_t seed = 1;
};

// What is taken where it is not said.
constexpr std::size_t usual_bodies = 100;
constexpr double usual_turn = 0.1;
constexpr const char* usual_shape = "sphere386";

scene::NamedShape chosen_shape(const AdviseArguments& options) {
    if (!options.meshes.empty()) {
        auto shapes = scene::mesh_shapes(options.meshes.front(), scene::MeshGrouping::one_hull);
        if (!shapes.warning.empty()) warn(shapes.warning);
        return std::move(shapes).or_throw().front();
    }
    const std::string name = options.vertices ? fmt::format("sphere{}", *options.vertices) : usual_shape;
    return {name, "built-in", scene::make_shape(name).or_throw(), {}};
}

Needs chosen_needs(const std::string& name) {
    const auto needs = needs_from(name);
    if (!needs || *needs == Needs::nearer)
        throw std::invalid_argument("--needs: " +
                                    unknown_name("need", name, {needs_names.begin() + 1, needs_names.end()}));
    return *needs;
}

/// Each input that nobody gave, with what stands in its place.
std::vector<std::string> assumptions(const AdviseArguments& options) {
    std::vector<std::string> assumed;
    if (!options.scene.empty()) return assumed;
    if (!options.own && !options.shared)
        assumed.emplace_back(
            "one table for all bodies (--own-tables: each has its own; the answer may flip)");
    if (!options.bodies) assumed.push_back(fmt::format("{} bodies (--bodies)", usual_bodies));
    if (!options.vertices && options.meshes.empty())
        assumed.push_back(fmt::format("the body is {} (--mesh FILE, or --vertices)", usual_shape));
    if (!options.turn) assumed.push_back(fmt::format("bodies turn by {} rad per step (--turn)", usual_turn));
    if (options.machines.empty()) assumed.emplace_back("caches of this machine (--machine NAME, or l2=256K)");
    return assumed;
}

/// Of a scene file its first point.
void take_scene_file(const AdviseArguments& options, studies::advise::CaseAsked& asked) {
    auto file = scene::find_scene_file(options.scene);
    if (!file)
        throw std::invalid_argument("--scene " + options.scene +
                                    ": a file NAME.json, or one of edgewise list scene_files");
    if (!file->warning.empty()) warn(file->warning);
    const scene::SceneFile scene = std::move(*file).or_throw();
    asked.shape = scene.shapes.front();
    if (asked.shape.source != "built-in")
        throw std::invalid_argument("--scene " + options.scene +
                                    ": for a mesh write --mesh FILE, --bodies and --turn");
    asked.scene = {scene.kind, scene.points.front().parameters};
    asked.own_tables =
        asked.scene.parameters.contains("own_tables") && asked.scene.parameters["own_tables"] > 0;
    if (scene.points.size() > 1)
        warn(
            fmt::format("{}: of its {} points the first is asked about", options.scene, scene.points.size()));
}

studies::advise::CaseAsked case_asked(const AdviseArguments& options) {
    studies::advise::CaseAsked asked;
    if (options.scene.empty()) {
        asked.shape = chosen_shape(options);
        if (!options.meshes.empty()) asked.mesh = options.meshes.front();
        asked.scene = studies::advise::tumbling(options.bodies.value_or(usual_bodies),
                                                options.turn.value_or(usual_turn));
        asked.own_tables = options.own;
    } else {
        take_scene_file(options, asked);
    }
    asked.needs = chosen_needs(options.needs);
    asked.error_limit = options.error;
    asked.seed = options.seed;
    return asked;
}

/// What a store says already.
int answer_from_store(const AdviseArguments& options, bool json) {
    reports::Question question;
    question.error_limit = options.error;
    if (options.own || options.shared) question.own_tables = options.own;
    if (options.vertices) question.shape = fmt::format("sphere{}", *options.vertices);
    const reports::ReportData data = reports::read_report(options.store);
    const reports::Answer answer = reports::answer_of(data, question);
    if (answer.scenes().empty())
        throw std::invalid_argument(
            fmt::format("{}: no scene of these bodies was measured; leave --store out to "
                        "measure now",
                        options.store));
    if (json) {
        fmt::print("{}\n", reports::answer_json(answer).dump());
    } else {
        fmt::print("{}\nfrom {}; nothing was measured now\n", reports::answer_paragraph(answer, data),
                   options.store);
    }
    const bool any =
        std::ranges::any_of(answer.scenes(), [](const auto* scene) { return scene->winner() != nullptr; });
    return any ? exit_done : exit_check_failed;
}

int run_advise(const AdviseArguments& options, bool json) {
    if (!options.store.empty()) return answer_from_store(options, json);
    if (options.meshes.size() > 1)
        throw std::invalid_argument("--mesh: advice is about one body at a time; ask for each");
    Advice advice;
    advice.asked = case_asked(options);
    advice.assumed = assumptions(options);
    advice.machines = options.machines;
    static_cast<void>(
        measure::choose_machines(options.machines));  // refuses unknown ones before anything runs
    measure_advice(advice, options.seconds, [json](const std::string& line) {
        if (!json) fmt::print(stderr, "{}\n", line);
    });
    fmt::print("{}", json ? advice_json(advice).dump() + "\n" : advice_text(advice));
    return advice.finals.ranked.empty() ? exit_check_failed : exit_done;
}

}  // namespace

void add_advise(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "advise",
                    "Which layout to take for your bodies, measured in less than a minute", run_advise);
    CLI::Option* const mesh = command->add_option("--mesh", options.meshes, "mesh file of the body");
    CLI::Option* const scene =
        command->add_option("--scene", options.scene, "a scene file, NAME.json, for all else")
            ->excludes(mesh);
    command->add_option("--vertices", options.vertices, "a sphere of so many vertices instead")
        ->excludes(mesh)
        ->excludes(scene);
    command->add_option("--bodies", options.bodies, "how many bodies")
        ->check(CLI::Range(2, 10000))
        ->excludes(scene);
    command->add_option("--turn", options.turn, "rad by which every body turns per step")
        ->check(CLI::NonNegativeNumber)
        ->excludes(scene);
    CLI::Option* const own =
        command->add_flag("--own-tables", options.own, "every body has a table of its own");
    command->add_flag("--shared-tables", options.shared, "all bodies have one table")->excludes(own);
    command->add_option("--error", options.error, "largest error of a distance, over the size of the pair")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--needs", options.needs, "what is asked of every answer")->capture_default_str();
    add_names(*command, "--machine", options.machines,
              "whose caches are modelled: a name, host, NAME.json, or sizes as in l2=256K,l3=8M");
    command->add_option("--time", options.seconds, "seconds that it may take, about")
        ->check(CLI::Range(5.0, 3600.0))
        ->capture_default_str();
    command->add_option("--store", options.store, "answer from this store, and measure nothing");
    command->add_option("--seed", options.seed, "seed of the scene")->capture_default_str();
}

}  // namespace edgewise::cli
