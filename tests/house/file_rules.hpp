// SPDX-License-Identifier: MIT
//
// Rules about single files: licence line, lengths, and what must not be in a tracked file.
#pragma once

#include <vector>

#include "source_tree.hpp"

namespace edgewise::house {

inline constexpr std::size_t longest_file = 400, longest_function = 40;

/// Sources, CMake files and scripts whose first three lines lack the licence.
[[nodiscard]] std::vector<Violation> missing_licences(const std::vector<SourceFile>& files);

[[nodiscard]] std::vector<Violation> long_files(const std::vector<SourceFile>& files);

/// Counted from the line that names the function to its closing brace. Goes by braces and by clang-format's
/// spacing: a body opens with " {", an initialiser does not.
[[nodiscard]] std::vector<Violation> long_functions(const std::vector<SourceFile>& files);

/// Names of package hosts, folders of one machine, and other people's code (by file type and by copyright
/// lines).
[[nodiscard]] std::vector<Violation> foreign_matter(const std::vector<SourceFile>& files);

/// Types that two headers define under one name in one namespace: no compiler sees both, and the linker takes
/// the functions of either for both.
[[nodiscard]] std::vector<Violation> types_named_twice(const std::vector<SourceFile>& files);

}  // namespace edgewise::house
