// SPDX-License-Identifier: MIT
//
// What every command file gives: a function that adds its subcommand and, when it is the one called, leaves
// its action. Exit codes: 0 done, 1 a check failed, 2 usage or bad input.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace edgewise::cli {

inline constexpr int exit_done = 0, exit_check_failed = 1, exit_bad_input = 2;

struct Context {
    bool json = false;
    std::function<int()> action;
};

/// Adds a subcommand with the option that all have, --json.
inline CLI::App* add_command(CLI::App& app, Context& context, const std::string& name,
                             const std::string& does) {
    CLI::App* command = app.add_subcommand(name, does);
    command->add_flag("--json", context.json, "machine-readable output on stdout");
    return command;
}

void add_additions(CLI::App& app, Context& context);
void add_bench(CLI::App& app, Context& context);
void add_bytes(CLI::App& app, Context& context);
void add_calibrate(CLI::App& app, Context& context);
void add_crosscheck(CLI::App& app, Context& context);
void add_draw(CLI::App& app, Context& context);
void add_heat(CLI::App& app, Context& context);
void add_list(CLI::App& app, Context& context);
void add_machine(CLI::App& app, Context& context);
void add_paging(CLI::App& app, Context& context);
void add_pass(CLI::App& app, Context& context);
void add_query(CLI::App& app, Context& context);
void add_report(CLI::App& app, Context& context);
void add_stability(CLI::App& app, Context& context);
void add_sweep(CLI::App& app, Context& context);

}  // namespace edgewise::cli
