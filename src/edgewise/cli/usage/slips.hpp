// SPDX-License-Identifier: MIT
//
// What a command line that cannot be read gets: one line that says what is wrong, which known name was
// probably meant, and what there is.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace edgewise::cli {

/// For CLI::App::failure_message.
[[nodiscard]] std::string one_line(const CLI::App* app, const CLI::Error& problem);

}  // namespace edgewise::cli
