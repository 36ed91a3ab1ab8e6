// SPDX-License-Identifier: MIT
//
// `edgewise record`: runs a model in MuJoCo or Bullet, or moves the joints of a robot, and writes a recording
// of its motion, for `edgewise sweep --scenes`. Each library is in a program of its own next to this one (an
// example), which a build has if the library is installed.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "edgewise/cli/options.hpp"
#include "edgewise/input/known_names.hpp"
#include "edgewise/input/output_file.hpp"
#include "edgewise/measure/process/child_process.hpp"
#include "edgewise/reports/page/html.hpp"

namespace edgewise::cli {

namespace {

struct RecordArguments {
    std::string model, out;
    double seconds = 5, rate = 60;
    std::optional<double> joints;
};

/// A program that records, with its model.
struct Engine {
    const char *program, *packages;
    std::string model;
};

Engine engine_of(std::string model) {
    static const std::vector<std::string> bullet = {"bullet-stack", "bullet-wall", "bullet-heap",
                                                    "bullet-heap0"};
    constexpr std::string_view of_mujoco = "mujoco:", of_bullet = "bullet-";
    if (std::ranges::find(bullet, model) != bullet.end())
        return {"record_bullet", "libbullet-dev", model.substr(of_bullet.size())};
    if (model.starts_with(of_mujoco)) model.erase(0, of_mujoco.size());
    if (model.ends_with(".xml") || model.ends_with(".urdf"))
        return {"record_mujoco", "libmujoco-dev libmujoco-samples", model};
    if (model.ends_with(".sdf") || model.ends_with(".world"))
        return {"record_sdformat", "libsdformat-dev", model};
    throw std::invalid_argument(unknown_name("model", model, bullet) +
                                ", or the path of a file that ends in .xml (MJCF), .urdf, .sdf or .world");
}

/// MJCF alone has actuators: the joints of others move as asked.
std::string joint_speed(const RecordArguments& options, const Engine& engine) {
    const bool is_bullet = engine.program == std::string_view("record_bullet");
    if (is_bullet && options.joints)
        throw std::invalid_argument(options.model + ": --joints is for robots, which have joints");
    return fmt::format("{}", options.joints.value_or(is_bullet || engine.model.ends_with(".xml") ? 0 : 1));
}

/// Messages of an engine, without the line end behind them and those within.
std::string on_one_line_of(std::string messages) {
    std::ranges::replace(messages, '\n', ' ');
    return on_one_line(messages.substr(0, messages.find_last_not_of(' ') + 1));
}

int run_record(const RecordArguments& options, bool json) {
    const Engine engine = engine_of(options.model);
    const auto program =
        std::filesystem::read_symlink("/proc/self/exe").parent_path() / "recorders" / engine.program;
    if (!std::filesystem::exists(program))
        throw std::invalid_argument(fmt::format(
            "{}: this program was built without {}: install its engine (Debian: {}) and build again",
            options.model, engine.program, engine.packages));
    const auto ran = measure::run_program({program.string(), engine.model, fmt::format("{}", options.seconds),
                                           fmt::format("{}", options.rate), joint_speed(options, engine)});
    if (!ran.value) throw std::runtime_error(ran.reason);
    constexpr int by_signal = 128;
    if (ran.value->exit_code > by_signal)
        throw std::invalid_argument(fmt::format("{}: the engine crashes on this model (signal {})",
                                                options.model, ran.value->exit_code - by_signal));
    if (ran.value->exit_code != 0)
        throw std::invalid_argument(fmt::format("{} ended with {}: {}", engine.program, ran.value->exit_code,
                                                on_one_line_of(ran.value->err)));
    if (!ran.value->err.empty()) warn(on_one_line_of(ran.value->err));
    const std::string& text = ran.value->out;
    input::write_output(options.out, options.out.ends_with(".gz") ? reports::gzipped(text) : text);
    const auto steps = std::ranges::count(text, '\n') - 1;  // after the header
    if (json)
        print_json(nlohmann::json{{"file", options.out}, {"steps", steps}});
    else
        fmt::print("{}: {} steps\n", options.out, steps);
    return exit_done;
}

}  // namespace

void add_record(CLI::App& app, Context& context) {
    auto [command, options] = add_command(
        app, context, "record",
        "Records the motion of a model in MuJoCo or Bullet, or of a robot's joints, to be swept", run_record);
    command
        ->add_option(
            "model", options.model,
            "bullet-stack, bullet-wall, bullet-heap, bullet-heap0 (hulls without margin), a file in MJCF, URDF "
            "or SDF (.xml, .urdf, .sdf, .world), or the name of a sample of MuJoCo")
        ->required();
    add_output_file(*command, "--out", options.out,
                    "file to write: the recording, ending in .jsonl or .jsonl.gz")
        ->required();
    add_number(*command, "--seconds", options.seconds, {0.01, 3600, "seconds"}, "how long the engine runs");
    add_number(*command, "--rate", options.rate, {0, 100'000, "steps per second"},
               "steps recorded per second; 0: every step of the engine");
    add_number(*command, "--joints", options.joints, {0, 1000, "rad/s"},
               "joints move at this speed between random places within their limits, without dynamics; 0: "
               "dynamics with random controls of MJCF, no motion in SDF (standard: 0 for MJCF, else 1)");
}

}  // namespace edgewise::cli
