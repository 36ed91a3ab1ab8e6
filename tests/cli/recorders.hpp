// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "cli_paths.hpp"

namespace edgewise::cli_test {

/// Returns true if this build has the engine's recorder, as the option of a build says.
inline bool has_recorder(const std::string& name) {
    return std::filesystem::exists(std::filesystem::path(program_path).parent_path() / "recorders" / name);
}

}  // namespace edgewise::cli_test
