// SPDX-License-Identifier: MIT
//
// CLI11 says what it did not expect, and not what it would have: names are compared here.
#include "edgewise/cli/usage/usage.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "edgewise/cli/command.hpp"
#include "edgewise/input/known_names.hpp"

namespace edgewise::cli {

namespace {

/// The command that was named, and below it the one of its own that was.
const CLI::App* named_command(const CLI::App* app) {
    while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
    return app;
}

/// Returns the rest of a line about an unknown option: the commands that have it, or how to write it.
std::string where_it_is(const CLI::App& app, const CLI::App& command, const std::string& option) {
    const std::string bare = option.substr(option.find_first_not_of('-'));
    for (const CLI::Option* known : command.get_options()) {
        if (known->get_positional() && known->get_name(true) == bare)
            return fmt::format("; write it without '{}'", option);
    }
    std::vector<std::string> having;
    for (const CLI::App* other : listed_commands(app)) {
        const auto options = option_names(*other);
        if (std::ranges::find(options, option) != options.end()) having.push_back(path_of(*other));
    }
    return having.empty() ? "" : fmt::format("; it is an option of {}", fmt::join(having, ", "));
}

std::string unexpected(const CLI::App& app, const CLI::App& command, const std::vector<std::string>& strays) {
    const auto option =
        std::ranges::find_if(strays, [](const std::string& stray) { return stray.starts_with("-"); });
    if (option == strays.end())
        return fmt::format("{} takes no further argument '{}'", path_of(command), strays.front());
    const std::string name = option->substr(0, option->find('='));
    return unknown_name("option", name, option_names(command)) + where_it_is(app, command, name);
}

/// Returns a line on a command of an earlier version that was renamed; empty for any other words. These lines
/// are for one release.
std::string line_on_old_name(const CLI::App& command, const std::vector<std::string>& strays) {
    static const std::map<std::string, std::string> new_names = {
        {"budget", "advise budget"},  {"thrash", "paging thrash"},        {"claims", "report claims"},
        {"heat", "draw heat"},        {"crosscheck", "bench crosscheck"}, {"effort", "bench effort"},
        {"scaling", "bench scaling"}, {"calibrate", "bench calibrate"},
    };
    if (path_of(command) == "bench" && std::ranges::find(strays, "--gate") != strays.end())
        return "bench --gate FILE is now 'edgewise bench gate FILE'";
    if (command.get_parent()) return "";
    if (strays.front() == "progress")
        return "progress: gone; a sweep says while it runs how much time is left";
    const auto renamed = new_names.find(strays.front());
    return renamed == new_names.end()
               ? ""
               : fmt::format("{} is now 'edgewise {}'", renamed->first, renamed->second);
}

}  // namespace

std::string one_line(const CLI::App* app, const CLI::Error& problem) {
    const CLI::App* const command = named_command(app);
    std::string what = problem.what();
    const std::vector<std::string> strays = app->remaining(true);
    if (command->get_require_subcommand_min() > 0) {
        const std::string kind = command == app ? "command" : "subcommand of " + command->get_name();
        const std::string renamed = strays.empty() ? "" : line_on_old_name(*command, strays);
        if (!renamed.empty())
            what = renamed;
        else if (strays.empty())
            what = fmt::format("no {}; known: {}", kind, fmt::join(command_names(*command), ", "));
        else
            what = unknown_name(kind, strays.front(), command_names(*command));
    } else if (dynamic_cast<const CLI::ExtrasError*>(&problem) && !strays.empty()) {
        what = unexpected(*app, *command, strays);
    }
    std::replace(what.begin(), what.end(), '\n', ' ');
    return "edgewise: " + what + "; --help says more\n";
}

}  // namespace edgewise::cli
