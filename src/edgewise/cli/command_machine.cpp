// SPDX-License-Identifier: MIT
//
// `edgewise machine`: what this machine is, which counters it has, and why not.
#include <fmt/format.h>

#include "edgewise/cli/command.hpp"
#include "edgewise/measure/machine/machine_json.hpp"
#include "edgewise/reports/tables/tables.hpp"

namespace edgewise::cli {

namespace {

struct MachineArguments {};

int run_machine(const MachineArguments& /*none*/, bool as_json) {
    const nlohmann::json machine = measure::machine_json();
    if (as_json) {
        print_json(machine);
        return exit_done;
    }
    for (const reports::TextGrid& grid : reports::machine_grids(machine)) fmt::print("{}\n", grid_text(grid));
    fmt::print("encodings of the events: --json\n");
    return exit_done;
}

}  // namespace

void add_machine(CLI::App& app, Context& context) {
    add_command(app, context, "machine",
                "What this machine is, and which counters it has, or why one is missing", run_machine);
}

}  // namespace edgewise::cli
