// SPDX-License-Identifier: MIT
//
// What every command file gives: a function that adds its subcommand and, when it is the one called, leaves
// its action. Exit codes: 0 done, 1 a check failed, 2 usage or bad input.
#pragma once

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/input/json_text.hpp"
#include "edgewise/input/shown_text.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::cli {

/// Where a sweep leaves its store when nobody says otherwise.
inline constexpr const char* default_store = "reports/out/edgewise.db";

/// Where its report goes then.
[[nodiscard]] inline std::string folder_of(const std::string& store) {
    const auto folder = std::filesystem::path(store).parent_path();
    return folder.empty() ? "." : folder.string();
}

/// Ctrl-C or SIGTERM: long work ends after the piece in hand.
inline std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

inline const std::atomic<bool>& stop_on_signals() {
    std::signal(SIGINT, [](int) { stop_requested = true; });
    std::signal(SIGTERM, [](int) { stop_requested = true; });
    return stop_requested;
}

/// A non-fatal problem.
inline void warn(const std::string& line) { fmt::print(stderr, "edgewise: {}\n", input::shown_line(line)); }

/// One line on stdout, for programs.
template <class Json>
void print_json(const Json& json) {
    fmt::print("{}\n", input::json_text(json));
}

inline constexpr int exit_done = 0, exit_check_failed = 1, exit_bad_input = 2;

struct Context {
    bool json = false;
    std::function<int()> action;
};

/// Adds a subcommand with the option that all have, --json; `run` is what it does with its other options,
/// which the caller adds.
template <class Options>
std::pair<CLI::App*, Options&> add_command(CLI::App& app, Context& context, const std::string& name,
                                           const std::string& does,
                                           int (*run)(const Options& options, bool json)) {
    CLI::App* command = app.add_subcommand(name, does);
    command->add_flag("--json", context.json, "machine-readable output on stdout");
    auto options = std::make_shared<Options>();
    command->callback([options, run, &context] {
        context.action = [options, run, &context] { return run(*options, context.json); };
    });
    return {command, *options};
}

/// An option of several names, which commas may separate as well as blanks.
inline void add_names(CLI::App& command, const char* option, std::vector<std::string>& to, const char* what) {
    command.add_option(option, to, what)->delimiter(',');
}

template <class Value>
[[nodiscard]] nlohmann::json or_null(const std::optional<Value>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
}
[[nodiscard]] inline nlohmann::json or_null(const std::string& text) {
    return text.empty() ? nlohmann::json() : nlohmann::json(text);
}

/// An array of what `json_of` makes of each item.
template <class Items, class JsonOf>
[[nodiscard]] nlohmann::json json_rows(const Items& items, JsonOf json_of) {
    nlohmann::json rows = nlohmann::json::array();
    for (const auto& item : items) rows.push_back(json_of(item));
    return rows;
}

/// Options that name one cell, for commands that look at one. The choice must live until the command's action
/// is done.
void add_cell_options(CLI::App& command, studies::CellChoice& choice);
/// Those of its scene alone.
void add_scene_options(CLI::App& command, studies::CellChoice& choice);

/// --parameter NAME=NUMBER, as often as wanted.
CLI::Option* add_parameter_option(CLI::App& command, scene::SceneParameters& parameters);
/// "rotation_step=0.1"; throws CLI::ValidationError.
void take_parameter(const std::string& text, scene::SceneParameters& parameters);

/// --sub-distance: how GJK solves its simplices, by name.
void add_sub_distance_option(CLI::App& command, SubDistanceSolver& solver);

/// --margin: what --needs nearer asks about.
void add_margin_option(CLI::App& command, std::optional<double>& margin);

void add_advise(CLI::App& app, Context& context);
void add_additions(CLI::App& app, Context& context);
void add_bench(CLI::App& app, Context& context);
void add_budget(CLI::App& app, Context& context);
void add_bytes(CLI::App& app, Context& context);
void add_caches(CLI::App& app, Context& context);
void add_calibrate(CLI::App& app, Context& context);
void add_campaign(CLI::App& app, Context& context);
void add_compare(CLI::App& app, Context& context);
void add_crosscheck(CLI::App& app, Context& context);
void add_draw(CLI::App& app, Context& context);
void add_effort(CLI::App& app, Context& context);
void add_export(CLI::App& app, Context& context);
void add_fields(CLI::App& app, Context& context);
void add_heat(CLI::App& app, Context& context);
void add_judge(CLI::App& app, Context& context);
void add_list(CLI::App& app, Context& context);
void add_lock(CLI::App& app, Context& context);
void add_machine(CLI::App& app, Context& context);
void add_merge(CLI::App& app, Context& context);
void add_paging(CLI::App& app, Context& context);
void add_pass(CLI::App& app, Context& context);
void add_query(CLI::App& app, Context& context);
void add_report(CLI::App& app, Context& context);
void add_scaling(CLI::App& app, Context& context);
void add_stability(CLI::App& app, Context& context);
void add_sweep(CLI::App& app, Context& context);
void add_thrash(CLI::App& app, Context& context);

}  // namespace edgewise::cli
