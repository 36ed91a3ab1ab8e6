// SPDX-License-Identifier: MIT
//
// Whole files in and out. A file is written under a second name and renamed into place, so a reader never
// sees half a page.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace edgewise::reports {

/// Returns a name for a file: the letters, digits, '_' and '-' of `name`, other bytes as '_'; a long name
/// becomes its beginning and a hash.
[[nodiscard]] std::string file_name_of(std::string name);
/// Returns a file name that is not yet in the set, changed if another name has it already.
[[nodiscard]] std::string file_name_of(const std::string& name, const std::set<std::string>& taken);

/// Returns the file's text; null when the file cannot be read.
[[nodiscard]] std::optional<std::string> read_file(const std::filesystem::path& path);
/// Throws std::runtime_error with one line naming the file.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace edgewise::reports
