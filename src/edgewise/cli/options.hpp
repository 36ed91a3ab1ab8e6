// SPDX-License-Identifier: MIT
//
// Options that several commands have. Each has its name and its text here, so that it means the same in every
// command. Numbers are read as plans and scene files read theirs (input/count.hpp): no option leaves its
// number to CLI11, which takes nan, inf, 0x10, ' 5' and '+5'.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "edgewise/cli/command.hpp"
#include "edgewise/input/count.hpp"
#include "edgewise/measure/record/comparison.hpp"
#include "edgewise/scene/mesh/mesh_file.hpp"
#include "edgewise/studies/single_cell.hpp"
#include "edgewise/sweep/plan.hpp"
#include "edgewise/sweep/shard.hpp"

namespace edgewise::cli {

template <class Value>
inline constexpr bool is_vector = false;
template <class Value>
inline constexpr bool is_vector<std::vector<Value>> = true;

/// An option with one number (a number or std::optional of it), or with several (std::vector), which commas
/// may separate. A text that is none is refused with the option's name, the text and the valid range.
template <class To, class Range, class Value>
CLI::Option* add_value(CLI::App& command, const std::string& names, To& to, const Range& range,
                       const std::string& what, const char* type,
                       Result<Value> (*parse)(std::string_view text, const Range& range)) {
    const std::string name = names.substr(0, names.find(','));
    CLI::Option* const option = command.add_option_function<std::vector<std::string>>(
        names,
        [&to, name, range, parse](const std::vector<std::string>& texts) {
            const auto value_of = [&](const std::string& text) {
                const Result<Value> value = parse(text, range);
                if (!value) throw CLI::ValidationError(fmt::format("{} {}", name, value.error));
                return *value;
            };
            if constexpr (is_vector<To>) {
                to.clear();
                for (const std::string& text : texts)
                    to.push_back(static_cast<typename To::value_type>(value_of(text)));
            } else if constexpr (std::is_arithmetic_v<To>) {
                to = static_cast<To>(value_of(texts.front()));
            } else {
                to = static_cast<typename To::value_type>(value_of(texts.front()));
            }
        },
        what);
    if constexpr (is_vector<To>)
        option->delimiter(',');
    else
        option->expected(1)->allow_extra_args(false);
    if constexpr (std::is_arithmetic_v<To>) option->default_str(fmt::format("{}", to));
    return option->type_name(type);
}

template <class To>
CLI::Option* add_count(CLI::App& command, const std::string& names, To& to, const input::CountRange& range,
                       const std::string& what) {
    return add_value(command, names, to, range, what, "COUNT", input::parse_count);
}

template <class To>
CLI::Option* add_number(CLI::App& command, const std::string& names, To& to, const input::NumberRange& range,
                        const std::string& what) {
    return add_value(command, names, to, range, what, "NUMBER", input::parse_number);
}

template <class To>
CLI::Option* add_seed_option(CLI::App& command, To& seed) {
    return add_count(command, "--seed", seed, input::seed_range, "seed of scenes, orders and generators");
}
template <class To>
CLI::Option* add_queries_option(CLI::App& command, To& queries,
                                const input::CountRange& range = input::queries_range) {
    return add_count(command, "--queries", queries, range, "queries per cell in each pass");
}
template <class To>
CLI::Option* add_checked_option(CLI::App& command, To& checked) {
    return add_count(command, "--checked", checked, input::queries_range, "queries checked exactly per cell");
}
template <class To>
CLI::Option* add_rounds_option(CLI::App& command, To& rounds, const input::CountRange& range) {
    return add_count(command, "--rounds", rounds, range, "interleaved rounds of timing");
}
template <class To>
CLI::Option* add_slack_option(CLI::App& command, To& slack, const std::string& usual) {
    return add_number(command, "--slack", slack, {0, 100},
                      "a time may become longer by this part of itself" + usual);
}

/// --wait, for say_how_quiet.
CLI::Option* add_wait_option(CLI::App& command, bool& waits);
/// Says in one line on stderr how quiet the machine is before something is timed. If it is busy and `waits`,
/// waits up to a minute for it to become quiet. With `json` it says nothing.
void say_how_quiet(bool waits, bool json);

/// An option of several names, which commas may separate as well as blanks.
CLI::Option* add_names(CLI::App& command, const char* option, std::vector<std::string>& to, const char* what);

/// --table: one table type; also with its earlier name.
CLI::Option* add_table_option(CLI::App& command, std::string& table, const char* names = "--table");
/// --layouts: several of them.
CLI::Option* add_layouts_option(CLI::App& command, std::vector<std::string>& layouts);
CLI::Option* add_algorithm_option(CLI::App& command, std::string& algorithm);
CLI::Option* add_algorithms_option(CLI::App& command, std::vector<std::string>& algorithms);
CLI::Option* add_peers_option(CLI::App& command, std::vector<std::string>& peers);
/// --machines: whose caches are modelled.
CLI::Option* add_machines_option(CLI::App& command, std::vector<std::string>& machines);
/// --families of hard cases.
CLI::Option* add_families_option(CLI::App& command, std::vector<std::string>& families);

/// A store as an argument, or as --store.
CLI::Option* add_read_store_option(CLI::App& command, std::string& store);
/// --store of a command that also runs without one, or writes it.
CLI::Option* add_store_option(CLI::App& command, std::string& store, const std::string& what);

/// --format of a comparison of records; none: text for people. Not with --json.
void add_format_option(CLI::App& command, std::string& format);
/// Prints a comparison with a record's file: as JSON, in the format, or as text after a line `before`.
/// Returns the exit code.
int print_comparison(const measure::RecordComparison& found, const std::string& old_name, bool json,
                     const std::string& format = {}, const std::string& before = {});

/// --svg FILE.
CLI::Option* add_svg_option(CLI::App& command, std::string& file);

/// One body, built in or from a mesh file, and --as-stored; --mesh is another name of --shape.
CLI::Option* add_shape_option(CLI::App& command, std::string& shape, bool& as_stored,
                              const char* names = "--shape,--mesh");
/// Several bodies.
CLI::Option* add_shapes_option(CLI::App& command, std::vector<std::string>& shapes, bool& as_stored);
/// Takes these bodies instead of the plan's; their files must be readable.
void take_bodies(const std::vector<std::string>& shapes, sweep::Plan& plan);

/// What the cell's queries are about, for people: the shape, unless it is a recording.
[[nodiscard]] std::string bodies_of(const studies::CellChoice& choice);

/// One body of a command that needs no scene.
struct BodyChoice {
    std::string shape = "sphere386";
    bool as_stored = false;  ///< of a mesh file (scene::MeshReading)
};

/// The body, or the hull of the mesh file in its own size; a flat one if `takes_flat`. Warns of what is odd
/// about a file; throws std::invalid_argument: what, where, what to do.
[[nodiscard]] scene::MeshBody chosen_body(const BodyChoice& choice, bool takes_flat = false);
/// The body as scenes have it: that of a mesh file is scaled as in a sweep.
[[nodiscard]] scene::NamedShape chosen_shape(const BodyChoice& choice);

/// Options that name one cell, for commands that look at one. The choice must live until the command's action
/// is done.
void add_cell_options(CLI::App& command, studies::CellChoice& choice);
/// Those of its scene alone.
void add_scene_options(CLI::App& command, studies::CellChoice& choice);
CLI::Option* add_scene_option(CLI::App& command, std::string& scene);
/// --scene of a command that asks kinds of scenes alone: a recording is refused, and the command that takes
/// it is named.
void refuse_recordings(CLI::App& command);

/// --parameter NAME=NUMBER, as often as wanted.
CLI::Option* add_parameter_option(CLI::App& command, scene::SceneParameters& parameters);
/// "rotation_step=0.1"; throws CLI::ValidationError.
void take_parameter(const std::string& text, scene::SceneParameters& parameters,
                    const char* option = "--parameter");

/// --needs: what is asked of every answer.
void add_needs_option(CLI::App& command, std::function<void(Needs)> take, Needs usual);
/// --sub-distance: how GJK solves its simplices, by name.
void add_sub_distance_option(CLI::App& command, SubDistanceSolver& solver);
/// --margin: what --needs nearer asks about.
void add_margin_option(CLI::App& command, std::optional<double>& margin);

/// --shard: a part of work that is divided over processes.
void add_shard_option(CLI::App& command, std::string& shard);
/// --shard and --costs.
void add_shard_options(CLI::App& command, std::string& shard, std::string& costs);
/// Returns the shard that --shard names; the whole if it is empty. Throws std::invalid_argument.
[[nodiscard]] sweep::Shard chosen_shard(const std::string& text);

// Folders that a command may make: one new folder in a folder that exists. A path that begins with several
// folders which do not exist is a typing error.

/// An option that names a file to be written (input/output_file.hpp). A path that cannot be written is
/// refused before any work is done.
CLI::Option* add_output_file(CLI::App& command, const std::string& name, std::string& to,
                             const std::string& what);

/// Throws std::invalid_argument where neither the folder nor the one above it exists. `option`: what the path
/// was given as.
void check_folder(const std::string& folder, const std::string& option);
/// Checks the folder of a file; the folder of the default store may always be made.
void check_folder_of(const std::string& file, const std::string& option);

/// Makes the folder unless it is there, after that check.
void make_folder(const std::string& folder, const std::string& option);

/// Makes the folder of a file; that of the default store with the folders above it.
void make_folder_of(const std::string& file, const std::string& option);

}  // namespace edgewise::cli
