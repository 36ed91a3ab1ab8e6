// SPDX-License-Identifier: MIT
//
// `edgewise pass`: runs passes over one cell's queries and nothing else, for tools that look at the whole
// program. One pass first fills caches; the others are what is to be observed, and what Callgrind collects
// when told not to begin at the start. Prints how many queries the first pass had and the sum of their
// distances, so that whoever counts them knows that they were answered right. Not listed: `edgewise bench
// crosscheck` and `edgewise bench effort` call it.
#include <fmt/format.h>

#include "edgewise/cli/options.hpp"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_TOGGLE_COLLECT
#endif

namespace edgewise::cli {

namespace {

struct PassArguments {
    studies::CellChoice cell;
    int passes = 1;
};

/// While one lives, Callgrind collects if the program runs under it with --collect-atstart=no.
class CollectedRegion {
  public:
    CollectedRegion() { CALLGRIND_TOGGLE_COLLECT; }
    ~CollectedRegion() { CALLGRIND_TOGGLE_COLLECT; }
    CollectedRegion(const CollectedRegion&) = delete;
    CollectedRegion& operator=(const CollectedRegion&) = delete;
};

int run_pass(const PassArguments& options) {
    const studies::SingleCell cell(options.cell);
    const std::function<bench::PassSum()> pass = cell.runner().prepared_pass();
    const bench::PassSum first = pass();
    {
        const CollectedRegion collected;
        for (int i = 0; i < options.passes; ++i) static_cast<void>(pass());
    }
    fmt::print("{} {}\n", first.queries, first.distances);
    return exit_done;
}

}  // namespace

void add_pass(CLI::App& app, Context& context) {
    auto options = std::make_shared<PassArguments>();
    CLI::App* command = app.add_subcommand("pass", "Runs one cell's queries, for tools that watch");
    command->group("");
    add_cell_options(*command, options->cell);
    command->add_option("--peer", options->cell.peer,
                        "another library instead of a table type and an algorithm");
    add_count(*command, "--passes", options->passes, {1, 1'000'000, "passes"}, "after the first");
    command->callback([options, &context] { context.action = [=] { return run_pass(*options); }; });
}

}  // namespace edgewise::cli
