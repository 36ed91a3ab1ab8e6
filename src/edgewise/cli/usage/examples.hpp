// SPDX-License-Identifier: MIT
//
// The end of every command's --help: two command lines that can be typed as they are.
#pragma once

#include <CLI/CLI.hpp>

namespace edgewise::cli {

/// For all commands that have been added to the app.
void add_examples(CLI::App& app);

}  // namespace edgewise::cli
