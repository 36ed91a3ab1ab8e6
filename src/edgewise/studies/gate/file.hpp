// SPDX-License-Identifier: MIT
//
// A gate's record as JSON: the baseline that a user keeps for a machine.
//
//     {"gate": 1, "machine": "...", "build": {"git_revision", "compiler", "flags", "build_type"},
//      "rounds": 17, "queries": 1000, "slack": 0.1,
//      "entries": [{"algorithm", "table", "scene", "shape", "axes", "over": "reference" or "kernel",
//                   "ratio", "low", "high"}]}
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "edgewise/geometry/result.hpp"
#include "edgewise/studies/gate/entry.hpp"

namespace edgewise::studies {

[[nodiscard]] nlohmann::json gate_json(const GateRecord& record);

/// Fails with one line: the file's name, the place in it, what is wanted there.
[[nodiscard]] Result<GateRecord> parse_gate(const std::string& name, const std::string& text);

[[nodiscard]] Result<GateRecord> read_gate(const std::string& path);

/// Throws std::runtime_error when the file cannot be written.
void write_gate(const std::string& path, const GateRecord& record);

}  // namespace edgewise::studies
