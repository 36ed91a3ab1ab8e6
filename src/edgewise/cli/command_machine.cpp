// SPDX-License-Identifier: MIT
//
// `edgewise machine`: what this machine is, which counters it has, and why not.
#include <fmt/format.h>

#include "edgewise/cli/command.hpp"
#include "edgewise/measure/machine/machine_json.hpp"

namespace edgewise::cli {

namespace {

/// One event: what it counts and by which code, then its value, or why there is none and what to do.
void print_counter(const nlohmann::json& counter) {
    const auto text = [&](const char* key) {
        return counter[key].is_string() ? counter[key].get<std::string>() : std::string("?");
    };
    fmt::print("  {:<20} {:<17} {}\n", text("event"), text("level"), text("meaning"));
    fmt::print("    by {}: {}\n", text("by"), text("encoding"));
    if (counter["status"] == "counted") {
        fmt::print("    counted: {}{}\n", counter["value"].dump(), counter["unit"] == "ns" ? " ns" : "");
    } else {
        const std::string error =
            counter["errno"].is_null() ? "" : fmt::format(" (errno {})", counter["errno"].dump());
        fmt::print("    unavailable{}: {}. {}\n", error, text("reason"), text("remedy"));
    }
}

struct MachineArguments {};

int run_machine(const MachineArguments& /*none*/, bool as_json) {
    nlohmann::json machine = measure::machine_json();
    if (as_json) {
        fmt::print("{}\n", machine.dump());
        return exit_done;
    }
    const nlohmann::json counters = machine["counters"];
    machine.erase("counters");
    for (const auto& [key, value] : machine.items()) fmt::print("{}: {}\n", key, value.dump());
    fmt::print("counters:\n");
    for (const auto& counter : counters) print_counter(counter);
    return exit_done;
}

}  // namespace

void add_machine(CLI::App& app, Context& context) {
    add_command(app, context, "machine",
                "What this machine is, and which counters it has, or why one is missing", run_machine);
}

}  // namespace edgewise::cli
