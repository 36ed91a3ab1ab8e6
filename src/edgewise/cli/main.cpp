// SPDX-License-Identifier: MIT
//
// The command line: one file per command. Whatever a command throws ends as one line on stderr and exit
// code 2.
#include <algorithm>
#include <cstdio>
#include <exception>

#include "edgewise/cli/command.hpp"

namespace {

/// What is wrong and what to do, in one line; the commands by name when the command is what is wrong.
std::string one_line(const CLI::App* app, const CLI::Error& problem) {
    std::string what = problem.what();
    if (app->get_subcommands().empty()) {
        const auto strays = app->remaining();
        what = strays.empty() ? "no command" : "unknown command '" + strays.front() + "'";
        what += "; known:";
        for (const CLI::App* command : app->get_subcommands({})) what += ' ' + command->get_name();
    }
    std::replace(what.begin(), what.end(), '\n', ' ');
    return "edgewise: " + what + "; --help says more\n";
}

/// In the order of the help text.
void add_commands(CLI::App& app, edgewise::cli::Context& context) {
    using namespace edgewise::cli;
    add_sweep(app, context);
    add_thrash(app, context);
    add_stability(app, context);
    add_report(app, context);
    add_export(app, context);
    add_additions(app, context);
    add_bytes(app, context);
    add_draw(app, context);
    add_query(app, context);
    add_machine(app, context);
    add_fields(app, context);
    add_heat(app, context);
    add_caches(app, context);
    add_lock(app, context);
    add_paging(app, context);
    add_crosscheck(app, context);
    add_effort(app, context);
    add_scaling(app, context);
    add_calibrate(app, context);
    add_bench(app, context);
    add_pass(app, context);
    add_list(app, context);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace edgewise::cli;
    CLI::App app{"Edgewise: memory- and cache-focused profiling of convex collision detection"};
    app.require_subcommand(1);
    app.set_help_all_flag("--help-all", "Help of all commands");
    app.failure_message(one_line);
    Context context;
    add_commands(app, context);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? exit_done : exit_bad_input;
    }
    try {
        return context.action();
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "edgewise: %s\n", problem.what());
        return exit_bad_input;
    }
}
