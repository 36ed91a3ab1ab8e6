// SPDX-License-Identifier: MIT
//
// The commands that folders below reports/ add, as `edgewise claims`: each prints what a store says, or what
// two say differently.
#include <fmt/core.h>

#include "edgewise/cli/command.hpp"
#include "edgewise/measure/record/comparison.hpp"
#include "edgewise/reports/additions.hpp"

namespace edgewise::cli {

namespace {

struct StoreArguments {
    std::string store = default_store;
    std::string other;  ///< of --diff; empty: one store alone
};

int run_addition(const reports::Addition& addition, const StoreArguments& options, bool json) {
    const reports::ReportData data = reports::read_report(options.store);
    if (options.other.empty()) {
        fmt::print("{}", addition.command_text(data, json));
        return exit_done;
    }
    const measure::RecordComparison found = measure::compare(
        addition.command_record(data), addition.command_record(reports::read_report(options.other)));
    fmt::print("{}", json ? to_json(found) : input::shown_text(to_text(found, options.store)));
    return found.exit_code();
}

}  // namespace

void add_additions(CLI::App& app, Context& context) {
    for (const reports::Addition& addition : reports::additions()) {
        auto options = std::make_shared<StoreArguments>();
        CLI::App* command = app.add_subcommand(addition.command, addition.command_does);
        command->add_flag("--json", context.json, "machine-readable output on stdout");
        command->add_option("store", options->store, "store of a sweep")->capture_default_str();
        command->add_option("--diff", options->other,
                            "what another store says differently; exit code 1 where something does");
        command->callback([options, &addition, &context] {
            context.action = [=, &addition, &context] {
                return run_addition(addition, *options, context.json);
            };
        });
    }
}

}  // namespace edgewise::cli
