// SPDX-License-Identifier: MIT
//
// Whole files in and out. A file is written beside its name and renamed into place, so a reader never sees
// half a page.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace edgewise::reports {

/// Null when the file cannot be read.
[[nodiscard]] std::optional<std::string> read_file(const std::filesystem::path& path);
/// Throws std::runtime_error with one line naming the file.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace edgewise::reports
