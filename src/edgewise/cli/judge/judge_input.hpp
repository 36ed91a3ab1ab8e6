// SPDX-License-Identifier: MIT
//
// Where `edgewise judge` has its pair from: a text that was pasted, or two mesh files with poses.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "edgewise/scene/dumps/dump.hpp"

namespace edgewise::cli {

struct JudgeInput {
    std::string text;            ///< a file, or - for stdin
    std::string mesh_a, mesh_b;  ///< instead
    std::string pose_a, pose_b;  ///< of these
    bool as_stored = false;      ///< of these (scene::MeshReading)
};

void add_judge_input(CLI::App& command, JudgeInput& input);

/// Throws std::invalid_argument: what, where, what to do.
[[nodiscard]] scene::PastedPair read_judge_input(const JudgeInput& input);

/// What was read, for the user to compare with what was meant: both bodies and both poses.
[[nodiscard]] nlohmann::json read_json(const scene::PastedPair& pasted);
void print_read(const scene::PastedPair& pasted);

}  // namespace edgewise::cli
