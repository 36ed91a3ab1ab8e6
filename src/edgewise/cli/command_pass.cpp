// SPDX-License-Identifier: MIT
//
// `edgewise pass`: runs passes over one cell's queries and nothing else, for tools that look at the whole
// program. One pass first fills caches; the others are what is to be observed, and what Callgrind collects
// when told not to begin at the start. Not listed: `edgewise crosscheck` calls it.
#include "edgewise/cli/command.hpp"
#include "edgewise/measure/process/callgrind_region.hpp"

namespace edgewise::cli {

namespace {

struct PassArguments {
    studies::CellChoice cell;
    int passes = 1;
};

int run_pass(const PassArguments& options) {
    const studies::SingleCell cell(options.cell);
    const std::function<bench::PassSum()> pass = cell.runner().prepared_pass();
    static_cast<void>(pass());
    const measure::CallgrindRegion collected;
    for (int i = 0; i < options.passes; ++i) static_cast<void>(pass());
    return exit_done;
}

}  // namespace

void add_pass(CLI::App& app, Context& context) {
    auto options = std::make_shared<PassArguments>();
    CLI::App* command = app.add_subcommand("pass", "Runs one cell's queries, for tools that watch");
    command->group("");
    add_cell_options(*command, options->cell);
    command->add_option("--passes", options->passes, "after the first")->check(CLI::Range(1, 1'000'000));
    command->callback([options, &context] { context.action = [=] { return run_pass(*options); }; });
}

}  // namespace edgewise::cli
