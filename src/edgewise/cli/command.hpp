// SPDX-License-Identifier: MIT
//
// Every command file has a function that adds its subcommand, which leaves its action if it is the one that
// was called. Exit codes: 0 done, 1 a check failed, 2 usage or bad input,
// 3 a figure is over the hard limit of a record.
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

/// The store of a sweep without --store.
inline constexpr const char* default_store = "reports/out/edgewise.db";

/// The folder of a store, in which its report is written by default.
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

/// Prints a non-fatal problem, unless the same line was printed before.
void warn(const std::string& line);

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

/// The words that call a command after the program's name: "advise budget".
[[nodiscard]] std::string path_of(const CLI::App& command);

/// Commands that --help lists, each before those nested in it.
[[nodiscard]] std::vector<const CLI::App*> listed_commands(const CLI::App& app);

/// Adds a command that groups others: one of them must be named.
CLI::App& add_group(CLI::App& app, const std::string& name, const std::string& does);

/// Adds a subcommand with --json and the end of its --help: two command lines that can be typed. Its callback
/// calls `act` if none of the commands nested in it was named; then its own options are refused.
CLI::App* add_command(CLI::App& app, Context& context, const std::string& name, const std::string& does,
                      std::function<void()> act);

/// `run` is what the command does with its other options, which the caller adds.
template <class Options>
std::pair<CLI::App*, Options&> add_command(CLI::App& app, Context& context, const std::string& name,
                                           const std::string& does,
                                           int (*run)(const Options& options, bool json)) {
    auto options = std::make_shared<Options>();
    CLI::App* const command = add_command(app, context, name, does, [options, run, &context] {
        context.action = [options, run, &context] { return run(*options, context.json); };
    });
    return {command, *options};
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

/// Prints figures of merit of a store, one stable line each, for the harnesses of computing centres (ReFrame,
/// Benchpark, Ramble), FOM name = value unit: cells verified and failed, answers checked and wrong, and of
/// every algorithm on every table type the geometric mean of its time over the baseline's.
void print_figures_of_merit(const std::string& store);

// The program's commands, in the order of --help.
void add_sweep(CLI::App& app, Context& context);
void add_advise(CLI::App& app, Context& context);
void add_stability(CLI::App& app, Context& context);
void add_merge(CLI::App& app, Context& context);
void add_campaign(CLI::App& app, Context& context);
void add_report(CLI::App& app, Context& context);
void add_export(CLI::App& app, Context& context);
void add_compare(CLI::App& app, Context& context);
void add_bytes(CLI::App& app, Context& context);
void add_draw(CLI::App& app, Context& context);
void add_query(CLI::App& app, Context& context);
void add_judge(CLI::App& app, Context& context);
void add_machine(CLI::App& app, Context& context);
void add_caches(CLI::App& app, Context& context);
void add_lock(CLI::App& app, Context& context);
void add_paging(CLI::App& app, Context& context);
void add_fields(CLI::App& app, Context& context);
void add_bench(CLI::App& app, Context& context);
void add_pass(CLI::App& app, Context& context);
void add_record(CLI::App& app, Context& context);
void add_list(CLI::App& app, Context& context);

// Commands nested in others: in advise, paging, report, draw and bench.
void add_budget(CLI::App& advise, Context& context);
void add_effort(CLI::App& bench, Context& context);
void add_crosscheck(CLI::App& bench, Context& context);

}  // namespace edgewise::cli
