// SPDX-License-Identifier: MIT
//
// The rules of the house: each takes files and returns where they break it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace edgewise::house {

inline constexpr std::size_t longest_file = 400, longest_function = 40, readme_words = 900;

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

using Files = std::vector<SourceFile>;
using Violations = std::vector<Violation>;

/// Every file below the root except what git ignores and what builds leave behind.
[[nodiscard]] Files read_tree(const std::filesystem::path& root);

[[nodiscard]] SourceFile source_file(std::string path, const std::string& text);

[[nodiscard]] bool is_cpp(const SourceFile& file);

/// "FILE:LINE: WHAT", one line each; empty if there are none.
[[nodiscard]] std::string to_text(const Violations& violations);

/// Includes between rooms that are not allowed, and includes of our own files that are not written as
/// "edgewise/<room>/<file>". Rooms are the folders of src/edgewise, and layouts/, probes/, reports/. A room
/// may include what the rooms that it includes may include. Only generated units, which are no files of the
/// tree, include layouts/ and probes/: no other file names a layout.
[[nodiscard]] Violations forbidden_includes(const Files& files);

/// One violation per cycle of includes, at the include that closes it.
[[nodiscard]] Violations include_cycles(const Files& files);

/// Finds standard names in exported headers that do not include the header of the name, and names that the
/// check does not know. Another standard library may include fewer headers through the named ones.
[[nodiscard]] Violations missing_std_headers(const Files& files);

/// Finds sources, CMake files and scripts without the licence in their first three lines.
[[nodiscard]] Violations missing_licences(const Files& files);

[[nodiscard]] Violations long_files(const Files& files);

/// Functions, counted from the line that names the function to its closing brace. Relies on the indentation
/// that clang-format gives: the brace is a line of its own, under the first line of the function.
/// Returns the functions of more lines than this.
[[nodiscard]] Violations functions_beyond(std::size_t longest, const Files& files);
[[nodiscard]] Violations long_functions(const Files& files);

/// Names of package hosts, folders of one machine, and other people's code (by file type and copyright
/// lines).
[[nodiscard]] Violations foreign_matter(const Files& files);

/// Types that two headers define under one name in one namespace: no compiler sees both, and the linker takes
/// the functions of either for both.
[[nodiscard]] Violations types_named_twice(const Files& files);

/// Functions flattened, or kept from a sanitizer, by attributes of their own: under a user's sanitizers these
/// take g++ minutes to compile, or give false reports (geometry/inlining.hpp).
[[nodiscard]] Violations own_flattening(const Files& files);

/// Source files that a comment names and the tree does not have.
[[nodiscard]] Violations dead_mentions(const Files& files);

[[nodiscard]] Violations long_readme(const Files& files);

}  // namespace edgewise::house
