// SPDX-License-Identifier: MIT
#include "edgewise/cli/command.hpp"

#include <set>

#include "edgewise/cli/usage/usage.hpp"

namespace edgewise::cli {

namespace {

/// Refuses options that were given to a command before the name of a nested one, which would not see them.
void refuse_own_options(const CLI::App& command, const CLI::App& nested) {
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0 && option->get_name() != "--json")
            throw CLI::ValidationError(fmt::format("{} is an option of {}, not of {}: leave it out",
                                                   option->get_name(), path_of(command), path_of(nested)));
}

}  // namespace

void warn(const std::string& line) {
    static std::set<std::string> printed;
    if (printed.insert(line).second) fmt::print(stderr, "edgewise: {}\n", input::shown_line(line));
}

std::string path_of(const CLI::App& command) {
    const CLI::App* const parent = command.get_parent();
    if (!parent) return "";
    const std::string before = path_of(*parent);
    return before + (before.empty() ? "" : " ") + command.get_name();
}

std::vector<const CLI::App*> listed_commands(const CLI::App& app) {
    std::vector<const CLI::App*> listed;
    for (const CLI::App* command : app.get_subcommands({})) {
        if (command->get_group().empty()) continue;
        listed.push_back(command);
        for (const CLI::App* nested : listed_commands(*command)) listed.push_back(nested);
    }
    return listed;
}

CLI::App& add_group(CLI::App& app, const std::string& name, const std::string& does) {
    CLI::App* const group = app.add_subcommand(name, does);
    group->require_subcommand(1);
    group->footer(examples_of(path_of(*group)));
    return *group;
}

CLI::App* add_command(CLI::App& app, Context& context, const std::string& name, const std::string& does,
                      std::function<void()> act) {
    CLI::App* const command = app.add_subcommand(name, does);
    command->footer(examples_of(path_of(*command)));
    command->add_flag("--json", context.json, "machine-readable output on stdout");
    command->callback([command, act = std::move(act)] {
        if (const auto nested = command->get_subcommands(); !nested.empty())
            refuse_own_options(*command, *nested.front());
        else
            act();
    });
    return command;
}

}  // namespace edgewise::cli
