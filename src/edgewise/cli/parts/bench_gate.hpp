// SPDX-License-Identifier: MIT
//
// `edgewise bench --gate FILE`: the speed of this build held against a baseline of this machine.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/cli/command.hpp"

namespace edgewise::cli {

struct GateArguments {
    std::string file;
    bool write = false;
    int rounds = 17;
    std::optional<double> slack;
    std::vector<std::string> layouts = {"all"};
};

/// Options of `command` that only the gate has, and those that it does not take.
void add_gate_options(CLI::App& command, GateArguments& gate);

/// Measures, then writes the baseline or compares with it. Returns the exit code.
int run_gate_command(const GateArguments& gate, std::size_t queries, bool json);

}  // namespace edgewise::cli
