// SPDX-License-Identifier: MIT
//
// The command line: one file per command. Whatever a command throws ends as one line on stderr and exit
// code 2.
#include <cstdio>
#include <exception>
#include <new>

#include "edgewise/cli/command.hpp"
#include "edgewise/cli/usage/examples.hpp"
#include "edgewise/cli/usage/slips.hpp"

namespace {

using namespace edgewise::cli;

/// In the order of the help text.
constexpr void (*commands[])(CLI::App&, Context&) = {
    add_sweep,     add_advise, add_budget,     add_thrash,  add_stability, add_merge,
    add_campaign,  add_report, add_export,     add_compare, add_additions, add_bytes,
    add_draw,      add_query,  add_judge,      add_machine, add_heat,      add_caches,
    add_lock,      add_paging, add_crosscheck, add_effort,  add_fields,    add_scaling,
    add_calibrate, add_bench,  add_progress,   add_pass,    add_list};

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Edgewise: memory- and cache-focused profiling of convex collision detection"};
    app.require_subcommand(1);
    app.set_help_all_flag("--help-all", "Help of all commands");
    app.failure_message(one_line);
    bool parse_only = false;
    app.add_flag("--parse-only", parse_only, "reads the command line and does nothing")->group("");
    Context context;
    for (const auto add : commands) add(app, context);
    add_examples(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? exit_done : exit_bad_input;
    }
    try {
        return parse_only ? exit_done : context.action();
    } catch (const std::bad_alloc&) {
        std::fputs("edgewise: out of memory: ask for fewer queries or smaller bodies; what is stored stays\n",
                   stderr);
        return exit_bad_input;
    } catch (const std::exception& problem) {
        warn(problem.what());
        return exit_bad_input;
    }
}
