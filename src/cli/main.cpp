// SPDX-License-Identifier: MIT
//
// The command line: one file a command. Whatever a command throws ends as one line on stderr and exit code 2.
#include <cstdio>
#include <exception>

#include "edgewise/cli/command.hpp"

int main(int argc, char** argv) {
    using namespace edgewise::cli;
    CLI::App app{"Edgewise: memory- and cache-focused profiling of convex collision detection"};
    app.require_subcommand(1);
    app.set_help_all_flag("--help-all", "Help of all commands");
    Context context;
    add_sweep(app, context);
    add_report(app, context);
    add_bytes(app, context);
    add_query(app, context);
    add_machine(app, context);
    add_list(app, context);
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
