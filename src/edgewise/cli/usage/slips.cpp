// SPDX-License-Identifier: MIT
//
// CLI11 says what it did not expect, and not what it would have: names are compared here.
#include "edgewise/cli/usage/slips.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "edgewise/input/known_names.hpp"

namespace edgewise::cli {

namespace {

/// Of an app, without what --help hides.
std::vector<std::string> commands_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) {
        if (!command->get_group().empty()) names.push_back(command->get_name());
    }
    return names;
}

std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            if (!option->get_group().empty()) names.push_back("--" + name);
        }
    }
    return names;
}

/// The command that was named, and below it the one of its own that was.
const CLI::App* named_command(const CLI::App* app) {
    while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
    return app;
}

/// "--store" of a command that takes its store without the dashes, or of other commands.
std::string where_it_is(const CLI::App& app, const CLI::App& command, const std::string& option) {
    const std::string bare = option.substr(option.find_first_not_of('-'));
    for (const CLI::Option* known : command.get_options()) {
        if (known->get_positional() && known->get_name(true) == bare)
            return fmt::format("; write it without '{}'", option);
    }
    std::vector<std::string> having;
    for (const std::string& name : commands_of(app)) {
        const auto options = options_of(*app.get_subcommand(name));
        if (std::ranges::find(options, option) != options.end()) having.push_back(name);
    }
    return having.empty() ? "" : fmt::format("; it is an option of {}", fmt::join(having, ", "));
}

std::string unexpected(const CLI::App& app, const CLI::App& command, const std::vector<std::string>& strays) {
    const auto option =
        std::ranges::find_if(strays, [](const std::string& stray) { return stray.starts_with("-"); });
    if (option == strays.end())
        return fmt::format("{} takes no further argument '{}'", command.get_name(), strays.front());
    const std::string name = option->substr(0, option->find('='));
    return unknown_name("option", name, options_of(command)) + where_it_is(app, command, name);
}

/// Returns a line on a command of earlier versions; "" for any other name.
std::string gone(const std::string& name) {
    return name == "progress" ? "progress: gone; a sweep says while it runs how much time is left" : "";
}

}  // namespace

std::string one_line(const CLI::App* app, const CLI::Error& problem) {
    const CLI::App* const command = named_command(app);
    std::string what = problem.what();
    const std::vector<std::string> strays = app->remaining(true);
    if (!command->get_subcommands({}).empty()) {
        const std::string kind = command == app ? "command" : "subcommand of " + command->get_name();
        what = strays.empty() ? fmt::format("no {}; known: {}", kind, fmt::join(commands_of(*command), ", "))
               : command == app && !gone(strays.front()).empty()
                   ? gone(strays.front())
                   : unknown_name(kind, strays.front(), commands_of(*command));
    } else if (dynamic_cast<const CLI::ExtrasError*>(&problem) && !strays.empty()) {
        what = unexpected(*app, *command, strays);
    }
    std::replace(what.begin(), what.end(), '\n', ' ');
    return "edgewise: " + what + "; --help says more\n";
}

}  // namespace edgewise::cli
