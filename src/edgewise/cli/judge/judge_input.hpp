// SPDX-License-Identifier: MIT
//
// Where `edgewise judge` has its pair from: a text that was pasted, or two bodies with poses.
#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "edgewise/scene/dumps/dump.hpp"

namespace edgewise::cli {

struct JudgeInput {
    std::string text;            ///< a file, or - for stdin
    std::string body_a, body_b;  ///< instead: names or mesh files
    std::string pose_a, pose_b;  ///< poses of these bodies
    bool as_stored = false;      ///< of mesh files (scene::MeshReading)
};

void add_judge_input(CLI::App& command, JudgeInput& input);

/// Throws std::invalid_argument: what, where, what to do.
[[nodiscard]] scene::PastedPair read_judge_input(const JudgeInput& input);

/// Both bodies and both poses as they were read, for the user to compare with what was meant.
[[nodiscard]] nlohmann::json read_json(const scene::PastedPair& pasted);
void print_read(const scene::PastedPair& pasted);

}  // namespace edgewise::cli
