// SPDX-License-Identifier: MIT
//
// The project's own files as the rules of the house see them: every file below the root but what git ignores
// and what builds leave behind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace edgewise::house {

struct SourceFile {
    std::string path;  ///< relative to the root, with slashes
    std::vector<std::string> lines;
};

/// A rule that is broken, and where.
struct Violation {
    std::string file;
    std::size_t line = 0;  ///< from 1; 0 for the file as a whole
    std::string what;
};

[[nodiscard]] std::vector<SourceFile> read_tree(const std::filesystem::path& root);

[[nodiscard]] SourceFile source_file(std::string path, const std::string& text);

/// By the end of its path.
[[nodiscard]] bool is_cpp(const SourceFile& file);

/// file:line: what, a line each; "" for none.
[[nodiscard]] std::string to_text(const std::vector<Violation>& violations);

}  // namespace edgewise::house
