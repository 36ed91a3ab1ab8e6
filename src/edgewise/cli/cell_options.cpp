// SPDX-License-Identifier: MIT
#include "edgewise/cli/command.hpp"
#include "edgewise/cli/number_option.hpp"
#include "edgewise/input/known_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>

namespace edgewise::cli {

void take_parameter(const std::string& text, scene::SceneParameters& parameters) {
    const std::size_t equals = text.find('=');
    const auto number = equals == std::string::npos ? Result<double>::failure("no =")
                                                    : input::parse_number(text.substr(equals + 1));
    if (!number)
        throw CLI::ValidationError(fmt::format("--parameter {}: {}; write NAME=NUMBER", text, number.error));
    parameters[text.substr(0, equals)] = *number;
}

namespace {

template <class Value>
Value accepted(const std::string& option, const Result<Value>& value) {
    if (!value) throw CLI::ValidationError(fmt::format("{} {}", option, value.error));
    return *value;
}

Needs needs_named(const std::string& name) {
    if (const auto needs = needs_from(name)) return *needs;
    throw CLI::ValidationError("--needs: " +
                               unknown_name("need", name, {needs_names.begin(), needs_names.end()}));
}

}  // namespace

std::uint64_t value_of(const std::string& option, const std::string& text, const input::CountRange& range) {
    return accepted(option, input::parse_count(text, range));
}

double value_of(const std::string& option, const std::string& text, const input::NumberRange& range) {
    return accepted(option, input::parse_number(text, range));
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
    add_number(command, "--margin", margin, input::above_0,
               fmt::format("of --needs nearer: the distance asked about, over the larger body's extent "
                           "(else {})",
                           bench::usual_margin));
}

void add_cell_options(CLI::App& command, studies::CellChoice& choice) {
    command.add_option("--table", choice.table, "table type")->capture_default_str();
    command.add_option("--algorithm", choice.algorithm, "vclip or gjk")->capture_default_str();
    add_scene_options(command, choice);
}

void add_scene_options(CLI::App& command, studies::CellChoice& choice) {
    command.add_option("--scene", choice.scene, "scene")->capture_default_str();
    command.add_option("--shape", choice.shape, "built-in shape")->capture_default_str();
    add_count(command, "--queries", choice.queries, input::queries_range, "queries per pass");
    add_count(command, "--seed", choice.seed, input::seed_range, "seed of the scene");
    add_parameter_option(command, choice.parameters);
    command.add_option_function<std::string>(
        "--needs", [&choice](const std::string& name) { choice.needs = needs_named(name); },
        fmt::format("what is asked of every answer: {}", fmt::join(needs_names, ", ")));
    add_margin_option(command, choice.margin);
    add_sub_distance_option(command, choice.sub_distance);
}

}  // namespace edgewise::cli
