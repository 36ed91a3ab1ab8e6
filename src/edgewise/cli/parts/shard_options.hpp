// SPDX-License-Identifier: MIT
//
// Options of commands whose work can be dealt over processes.
#pragma once

#include <string>

#include "edgewise/cli/command.hpp"
#include "edgewise/sweep/shard.hpp"

namespace edgewise::cli {

/// --shard.
void add_shard_option(CLI::App& command, std::string& shard);
/// That and --costs.
void add_shard_options(CLI::App& command, std::string& shard, std::string& costs);

/// Of --shard, empty for the whole; throws std::invalid_argument.
[[nodiscard]] sweep::Shard chosen_shard(const std::string& text);

}  // namespace edgewise::cli
