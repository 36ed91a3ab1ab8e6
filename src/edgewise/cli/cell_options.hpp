// SPDX-License-Identifier: MIT
//
// Options that name one cell, for commands that look at one.
#pragma once

#include "edgewise/cli/command.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::cli {

/// The choice must live until the command's action is done.
void add_cell_options(CLI::App& command, studies::CellChoice& choice);

}  // namespace edgewise::cli
