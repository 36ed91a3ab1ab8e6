// SPDX-License-Identifier: MIT
//
// `edgewise advise`: which layout to take for a case of the user's, measured in less than a minute: every
// cell looked at, the best raced in several processes, the caches of the asked machine modelled; how sure
// that is, and what would change it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "edgewise/cli/advise/advice.hpp"
#include "edgewise/cli/options.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/reports/answer/answer_text.hpp"
#include "edgewise/reports/answer/decision.hpp"
#include "edgewise/scene/scene_file.hpp"
#include "edgewise/scene/scenes.hpp"

namespace edgewise::cli {

namespace {

using studies::advise::DroppedFor, studies::advise::Screen, studies::advise::ScreenedCell,
    studies::advise::TimeLimit;

// Parts of the time at which the first look and the race have to be over.
constexpr double until_screened = 0.4, until_raced = 0.8;
constexpr double until_screened_for_machines = 0.3;  ///< where machines were named, which the race models
constexpr std::size_t most_raced = 5;

/// The fastest few, the baseline, and the best of the algorithm that is not among them.
std::vector<ScreenedCell> cells_to_race(const Screen& screen) {
    std::vector<ScreenedCell> raced;
    const auto add_first = [&](const auto& wanted) {
        const auto found = std::ranges::find_if(screen.cells, wanted);
        if (found == screen.cells.end()) return;
        const bool known = std::ranges::any_of(raced, [&](const ScreenedCell& other) {
            return other.type == found->type && other.algorithm == found->algorithm;
        });
        if (!known) raced.push_back(*found);
    };
    for (const ScreenedCell& cell : screen.cells)
        if (cell.is_in() && raced.size() < most_raced) raced.push_back(cell);
    if (raced.empty()) return raced;
    add_first([](const ScreenedCell& cell) {
        return cell.is_baseline() && cell.dropped_for != DroppedFor::failure;
    });
    for (const char* algorithm : {"gjk", "vclip"})
        add_first([&](const ScreenedCell& cell) {
            return cell.algorithm == algorithm && (cell.is_in() || cell.dropped_for == DroppedFor::time);
        });
    return raced;
}

/// Runs the steps of an advice within a time limit and calls `say` with a line after each step. A step that
/// would take longer than the time left is skipped, and the advice names it.
class Measuring {
  public:
    Measuring(Advice& advice, double seconds, const std::function<void(const std::string&)>& say)
        : advice_(advice), seconds_(seconds), say_(say) {}

    void run() {
        look();
        if (const auto cells = cells_to_race(advice_.screen); !cells.empty()) race(cells);
        if (can_share(advice_.asked) && !stop_requested) look_at_other_tables();
        advice_.not_asked.emplace_back(
            "other velocities, other bodies; hardware counters (edgewise machine says which there are)");
        advice_.seconds = elapsed();
    }

  private:
    [[nodiscard]] double elapsed() const { return watch_.elapsed_ns() * 1e-9; }
    [[nodiscard]] TimeLimit until(double part) const {
        return TimeLimit([this] { return elapsed(); }, part * seconds_);
    }

    void look() {
        TimeLimit limit = until(advice_.machines.empty() ? until_screened : until_screened_for_machines);
        advice_.screen = screen(advice_.asked, {}, [&] { return stop_on_signals() || !limit.begin_piece(); });
        say_(fmt::format("looked at {} cells, {} dropped ({:.1f} s)", advice_.screen.cells.size(),
                         std::ranges::count(advice_.screen.cells, false, &ScreenedCell::is_in), elapsed()));
        looked_seconds_ = elapsed();
        if (advice_.screen.left_out > 0)
            advice_.left_out.push_back(
                fmt::format("{} of {} cells: no time was left to look at them (--time)",
                            advice_.screen.left_out, advice_.screen.cells.size() + advice_.screen.left_out));
    }

    void race(const std::vector<ScreenedCell>& cells) {
        advice_.race = run_race(advice_.asked, cells, {advice_.machines, until(until_raced).left()});
        const Race& race = advice_.race;
        const reports::SceneRanking* const scene = race.scene();
        say_(fmt::format("raced {} of them in {} processes ({:.1f} s)", scene ? scene->cells.size() : 0,
                         race.processes(), elapsed()));
        const int wanted = studies::advise::whole_race.processes;
        name_unmodelled_machines();
        const auto lost = std::ranges::count_if(cells, [&](const ScreenedCell& cell) {
            return !scene || !scene->find(cell.algorithm, cell.type->name);
        });
        if (lost > 0 && race.processes() > 0)
            advice_.left_out.push_back(fmt::format(
                "{} of the {} fastest cells: no time was left to race them (--time)", lost, cells.size()));
        if (race.processes() < wanted)
            advice_.left_out.push_back(fmt::format(
                "{} of {} processes: {}", wanted - race.processes(), wanted,
                race.problem.empty() ? "too long for the time that was left (--time)" : race.problem));
        if (race.taken() && !race.taken()->lines_per_query)
            advice_.left_out.emplace_back("lines, misses and a prediction: no time was left (--time)");
    }

    /// Before all else that there was no time for.
    void name_unmodelled_machines() {
        const reports::RankedCell* const taken = advice_.race.taken();
        const studies::advise::CacheCost* const cost = taken ? advice_.race.caches_of(*taken) : nullptr;
        std::vector<std::string> unmodelled;
        for (const measure::MachineChoice& choice : measure::choose_machines(advice_.machines)) {
            const bool modelled = cost && cost->misses.contains(choice.name);
            if (choice.machine.value && !modelled)
                unmodelled.push_back(
                    fmt::format("the caches of {}: no time was left to model them (--time)", choice.name));
        }
        advice_.left_out.insert(advice_.left_out.begin(), unmodelled.begin(), unmodelled.end());
    }

    /// Looks at the same case with a table each instead of a shared one, or the reverse, with fewer queries.
    /// Keeps no result unless the time is enough for all cells.
    void look_at_other_tables() {
        studies::advise::CaseAsked other = advice_.asked;
        other.own_tables = !other.own_tables;
        const char* const name = other.own_tables ? "a table each" : "one table for all";
        TimeLimit limit = until(1);
        const std::string no_time = fmt::format("{}: no time was left for all of it (--time)", name);
        if (limit.left() < looked_seconds_ / 2) return advice_.left_out.push_back(no_time);
        const Screen screen = studies::advise::screen(other, {.queries = 1000, .checked = 20, .passes = 3},
                                                      [&] { return !limit.begin_piece(); });
        if (screen.left_out > 0) return advice_.left_out.push_back(no_time);
        std::ranges::copy_if(screen.cells, std::back_inserter(advice_.other_tables), &ScreenedCell::is_in);
        say_(fmt::format("looked at the case with {} ({:.1f} s)", name, elapsed()));
    }

    Advice& advice_;
    double seconds_;
    const std::function<void(const std::string&)>& say_;
    measure::Stopwatch watch_;
    double looked_seconds_ = 0;
};

struct AdviseArguments {
    std::vector<std::string> machines;
    std::string shape, scene, store;
    std::optional<Needs> needs;
    std::optional<std::size_t> bodies, vertices;
    std::optional<double> turn;
    bool own = false, shared = false, as_stored = false, waits = false;
    double error = 1e-6, seconds = 45;
    std::uint64_t seed = 1;
};

// Values of options that are not given; turn and bodies are those of plan `quick`.
using studies::advise::usual_turn;
std::size_t bodies_asked(const AdviseArguments& options) {
    return options.bodies.value_or(studies::advise::usual_bodies(options.own));
}
constexpr const char* usual_shape = "sphere386";
constexpr Needs usual_needs = Needs::distance;

constexpr input::CountRange population_range{2, 10'000, "bodies"}, vertices_range{4, 100'000, "vertices"};

/// The body that is asked about: a built-in name, or a mesh file.
std::string shape_asked(const AdviseArguments& options) {
    if (options.vertices) return fmt::format("sphere{}", *options.vertices);
    return options.shape.empty() ? usual_shape : options.shape;
}

/// Each input that was not given, with the value that is used instead.
std::vector<std::string> assumptions(const AdviseArguments& options) {
    std::vector<std::string> assumed;
    if (options.scene.empty()) {
        if (!options.own && !options.shared)
            assumed.emplace_back(
                "one table for all bodies (--own-tables: each has its own; the answer may flip)");
        if (!options.bodies) assumed.push_back(fmt::format("{} bodies (--bodies)", bodies_asked(options)));
        if (!options.vertices && options.shape.empty())
            assumed.push_back(
                fmt::format("the body is {} (--shape NAME or FILE, or --vertices)", usual_shape));
        if (!options.turn)
            assumed.push_back(fmt::format("bodies turn by {} rad per step (--turn)", usual_turn));
        if (!options.needs)
            assumed.push_back(fmt::format("answers give the {} (--needs)", to_string(usual_needs)));
    }
    if (options.machines.empty())
        assumed.emplace_back("caches of this machine (--machines NAME, or l2=256K)");
    return assumed;
}

/// Takes the first point of a scene file.
void take_scene_file(const AdviseArguments& options, studies::advise::CaseAsked& asked) {
    auto file = scene::find_scene_file(options.scene, {.as_stored = options.as_stored});
    if (!file)
        throw std::invalid_argument("--scene " + options.scene +
                                    ": a file NAME.json, or one of edgewise list scene_files");
    if (!file->warning.empty()) warn(file->warning);
    const scene::SceneFile scene = std::move(*file).or_throw();
    if (scene.recording && options.scene.ends_with(".json"))
        throw std::invalid_argument("--scene " + options.scene +
                                    ": for motion of an engine name the recording itself");
    asked.shape = scene.shapes.front();
    if (scene.recording) {
        if (const std::string& note = scene.recording->note; !note.empty())
            warn(fmt::format("recording {}: {}", scene.recording->name, note));
        asked.recording = std::filesystem::absolute(options.scene);
        asked.as_stored = options.as_stored;
    } else if (asked.shape.source != "built-in") {
        throw std::invalid_argument("--scene " + options.scene +
                                    ": for a mesh write --shape FILE, --bodies and --turn");
    } else if (options.as_stored) {
        throw std::invalid_argument("--as-stored is for mesh files: this scene has none, so leave it out");
    }
    asked.scene = {
        .name = scene.kind, .parameters = scene.points.front().parameters, .recording = scene.recording};
    asked.needs = scene.needs;
    asked.own_tables =
        asked.scene.parameters.contains("own_tables") && asked.scene.parameters["own_tables"] > 0;
    if (scene.points.size() > 1)
        warn(
            fmt::format("{}: of its {} points the first is asked about", options.scene, scene.points.size()));
}

studies::advise::CaseAsked case_asked(const AdviseArguments& options) {
    studies::advise::CaseAsked asked;
    asked.needs = usual_needs;
    if (options.scene.empty()) {
        const std::string name = shape_asked(options);
        asked.shape = chosen_shape({name, options.as_stored});
        if (scene::names_mesh_file(name)) asked.mesh = name;
        asked.as_stored = options.as_stored;
        asked.scene = studies::advise::usual_scene(options.own, bodies_asked(options),
                                                   options.turn.value_or(usual_turn));
        asked.own_tables = options.own;
    } else {
        take_scene_file(options, asked);
        if (options.own || options.shared) asked.own_tables = options.own;
    }
    static_cast<void>(scene::complete_parameters(asked.scene.name, asked.scene.parameters).or_throw());
    if (options.needs) asked.needs = *options.needs;
    if (has_margin(asked.needs))
        throw std::invalid_argument(fmt::format(
            "--needs {}: no advice is about a margin; write --needs distance", to_string(asked.needs)));
    asked.error_limit = options.error;
    asked.seed = options.seed;
    return asked;
}

/// The command that asks for exactly this, whatever is assumed elsewhere.
std::string command_text(const AdviseArguments& options, const studies::advise::CaseAsked& asked) {
    std::string text = "edgewise advise";
    if (!options.scene.empty()) {
        text += " --scene " + options.scene;
    } else {
        text += " --shape " + (asked.mesh.empty() ? asked.shape.name : asked.mesh);
        text +=
            fmt::format(" --bodies {} --turn {}", bodies_asked(options), options.turn.value_or(usual_turn));
    }
    if (asked.as_stored) text += " --as-stored";
    if (options.scene.empty() || options.own || options.shared)
        text += asked.own_tables ? " --own-tables" : " --shared-tables";
    text += fmt::format(" --error {} --needs {}", asked.error_limit, to_string(asked.needs));
    if (!options.machines.empty()) text += fmt::format(" --machines {}", fmt::join(options.machines, ","));
    return text + fmt::format(" --seed {}", asked.seed);
}

/// Answers from what a store has already.
int answer_from_store(const AdviseArguments& options, bool json) {
    if (!options.scene.empty() || options.needs || !options.machines.empty() || options.bodies ||
        options.turn)
        throw std::invalid_argument(
            "--store answers from what was measured: leave --scene, --needs, --machines, --bodies and --turn out");
    reports::Question question;
    question.error_limit = options.error;
    if (options.own || options.shared) question.own_tables = options.own;
    if (options.vertices || !options.shape.empty())
        question.shape = std::filesystem::path(shape_asked(options)).stem();
    const reports::ReportData data = reports::read_report(options.store);
    const reports::Answer answer = reports::answer_of(data, question);
    if (answer.scenes().empty())
        throw std::invalid_argument(
            fmt::format("{}: no scene of these bodies was measured; leave --store out to "
                        "measure now",
                        options.store));
    if (json) {
        auto all = reports::answer_json(answer);
        all["changes_it"] = reports::Decisions(data, question).table(question.error_limit).changes;
        print_json(all);
    } else {
        fmt::print("{}\nfrom {}; nothing was measured now\n", reports::terminal_text(answer, data),
                   options.store);
    }
    const bool any =
        std::ranges::any_of(answer.scenes(), [](const auto* scene) { return scene->winner() != nullptr; });
    return any ? exit_done : exit_check_failed;
}

int run_advise(const AdviseArguments& options, bool json) {
    if (!options.store.empty()) return answer_from_store(options, json);
    Advice advice;
    advice.asked = case_asked(options);
    advice.assumed = assumptions(options);
    advice.command = command_text(options, advice.asked);
    advice.machines = options.machines;
    static_cast<void>(
        measure::choose_machines(options.machines));  // refuses unknown ones before anything runs
    say_how_quiet(options.waits, json);
    Measuring(advice, options.seconds, [json](const std::string& line) {
        if (!json) fmt::print(stderr, "{}\n", line);
    }).run();
    if (stop_requested) {
        warn("stopped: no advice");
        return exit_check_failed;
    }
    fmt::print("{}",
               json ? input::json_text(advice_json(advice)) + "\n" : input::shown_text(advice_text(advice)));
    return advice.race.taken() ? exit_done : exit_check_failed;
}

}  // namespace

void add_advise(CLI::App& app, Context& context) {
    auto [command, options] =
        add_command(app, context, "advise",
                    "Which layout to take for your bodies, measured in less than a minute", run_advise);
    CLI::Option* const scene = command->add_option(
        "--scene", options.scene,
        "scene: a file, NAME.json, or a recording of an engine or robot, instead of options on bodies");
    CLI::Option* const shape = add_shape_option(*command, options.shape, options.as_stored)->excludes(scene);
    add_count(*command, "--vertices", options.vertices, vertices_range,
              "how many vertices: a sphere with this number of them")
        ->excludes(scene)
        ->excludes(shape);
    add_count(*command, "--bodies", options.bodies, population_range, "how many bodies")->excludes(scene);
    add_number(*command, "--turn", options.turn, {0, input::any_number.most, "rad"},
               "rad by which every body turns per step")
        ->excludes(scene);
    CLI::Option* const own =
        command->add_flag("--own-tables", options.own, "every body has a table of its own");
    command->add_flag("--shared-tables", options.shared, "all bodies have one table")->excludes(own);
    add_number(*command, "--error", options.error, input::above_0,
               "largest error of a distance, over the size of the pair");
    add_needs_option(
        *command, [&needs = options.needs](Needs asked) { needs = asked; }, usual_needs);
    add_machines_option(*command, options.machines);
    add_wait_option(*command, options.waits);
    add_number(*command, "--time", options.seconds, {5, 3600, "seconds"}, "seconds that it may take");
    add_store_option(*command, options.store, "the answer is read there, and nothing is measured");
    add_seed_option(*command, options.seed);
    add_budget(*command, context);
}

}  // namespace edgewise::cli
