// SPDX-License-Identifier: MIT
//
// Texts on how commands are called: the line after a mistake, examples, the manual page, the table of
// options and what shells complete.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace edgewise::cli {

/// Returns one line on what is wrong with a command line, which known name was probably meant, and what
/// there is. For CLI::App::failure_message.
[[nodiscard]] std::string one_line(const CLI::App* app, const CLI::Error& problem);

/// examples.json.
extern const char* const example_texts;

/// completion.bash and the like: scripts with places for the paths of commands, and for a case of each.
extern const char *const bash_script, *const zsh_script, *const fish_script;

/// Returns the end of a command's --help: two command lines that can be typed as they are. `path`: the words
/// that call the command.
[[nodiscard]] std::string examples_of(const std::string& path);

/// Names of the texts that manual_text returns.
inline constexpr const char* manual_texts[] = {"options", "man", "bash", "zsh", "fish"};

/// Returns one text on all commands: a table of options in Markdown, the manual page in roff, or a completion
/// script for a shell.
[[nodiscard]] std::string manual_text(const CLI::App& app, const std::string& name);

}  // namespace edgewise::cli
