// SPDX-License-Identifier: MIT
//
// The command line: one file per command. Whatever a command throws ends as one line on stderr and exit
// code 2.
#include <cstdio>
#include <exception>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/usage/examples.hpp"
#include "edgewise/cli/usage/slips.hpp"

namespace {

using namespace edgewise::cli;

/// In the order of --help.
void add_commands(CLI::App& app, Context& context) {
    add_sweep(app, context);
    add_advise(app, context);
    add_budget(app, context);
    add_thrash(app, context);
    add_stability(app, context);
    add_report(app, context);
    add_export(app, context);
    add_additions(app, context);
    add_bytes(app, context);
    add_draw(app, context);
    add_query(app, context);
    add_judge(app, context);
    add_machine(app, context);
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
    CLI::App app{"Edgewise: memory- and cache-focused profiling of convex collision detection"};
    app.require_subcommand(1);
    app.set_help_all_flag("--help-all", "Help of all commands");
    app.failure_message(one_line);
    bool parse_only = false;
    app.add_flag("--parse-only", parse_only, "reads the command line and does nothing")->group("");
    Context context;
    add_commands(app, context);
    add_examples(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? exit_done : exit_bad_input;
    }
    try {
        return parse_only ? exit_done : context.action();
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "edgewise: %s\n", problem.what());
        return exit_bad_input;
    }
}
