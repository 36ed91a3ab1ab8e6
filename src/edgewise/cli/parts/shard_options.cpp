// SPDX-License-Identifier: MIT
#include "edgewise/cli/parts/shard_options.hpp"

#include <cstdlib>

namespace edgewise::cli {

void add_shard_option(CLI::App& command, std::string& shard) {
    command.add_option("--shard", shard,
                       "this part of it alone: i/n, from 0/n on; auto or auto/n: the part that a scheduler's "
                       "environment says");
}

void add_shard_options(CLI::App& command, std::string& shard, std::string& costs) {
    add_shard_option(command, shard);
    command.add_option("--costs", costs,
                       "store of an earlier run, whose seconds make parts even; the same for all");
}

sweep::Shard chosen_shard(const std::string& text) {
    if (text.empty()) return {};
    return sweep::parse_shard(text, [](const char* name) -> const char* { return std::getenv(name); })
        .or_throw();
}

}  // namespace edgewise::cli
