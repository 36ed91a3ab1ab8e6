// SPDX-License-Identifier: MIT
//
// `edgewise machine`: what this machine is, which counters it has, and why not.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "edgewise/cli/command.hpp"
#include "edgewise/measure/machine_json.hpp"

namespace edgewise::cli {

namespace {

void print_counters(const nlohmann::json& counters) {
    for (const auto& counter : counters) {
        if (counter["status"] == "counted") {
            fmt::print("  {:<24} counted\n", counter["event"].get<std::string>());
        } else {
            fmt::print("  {:<24} unavailable: {}. {}\n", counter["event"].get<std::string>(),
                       counter.value("reason", ""), counter.value("remedy", ""));
        }
    }
}

int run(bool json) {
    nlohmann::json machine = machine_json();
    if (json) {
        fmt::print("{}\n", machine.dump());
        return exit_done;
    }
    const nlohmann::json counters = machine["counters"];
    machine.erase("counters");
    for (const auto& [key, value] : machine.items()) fmt::print("{}: {}\n", key, value.dump());
    fmt::print("counters:\n");
    print_counters(counters);
    return exit_done;
}

}  // namespace

void add_machine(CLI::App& app, Context& context) {
    CLI::App* command =
        add_command(app, context, "machine", "What this machine is, which counters it has, and why not");
    command->callback([&context] { context.action = [&context] { return run(context.json); }; });
}

}  // namespace edgewise::cli
