// SPDX-License-Identifier: MIT
//
// The commands that folders below reports/ add, as `edgewise claims`: each prints what a store says.
#include <fmt/core.h>

#include "edgewise/cli/command.hpp"
#include "edgewise/reports/additions.hpp"

namespace edgewise::cli {

void add_additions(CLI::App& app, Context& context) {
    for (const reports::Addition& addition : reports::additions()) {
        auto store = std::make_shared<std::string>(default_store);
        CLI::App* command = app.add_subcommand(addition.command, addition.command_does);
        command->add_flag("--json", context.json, "machine-readable output on stdout");
        command->add_option("store", *store, "store of a sweep")->capture_default_str();
        command->callback([store, &addition, &context] {
            context.action = [=, &addition, &context] {
                fmt::print("{}", addition.command_text(reports::read_report(*store), context.json));
                return exit_done;
            };
        });
    }
}

}  // namespace edgewise::cli
