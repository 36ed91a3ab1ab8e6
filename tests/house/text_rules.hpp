// SPDX-License-Identifier: MIT
//
// Rules about how much stands in one place, and about what comments point to.
#pragma once

#include <cstddef>
#include <vector>

#include "source_tree.hpp"

namespace edgewise::house {

inline constexpr std::size_t longest_class = 150, readme_lines = 120, readme_words = 900;

/// Functions flattened, or kept from a sanitizer, by attributes of their own: under a user's sanitizers these
/// take g++ minutes to compile, or give false reports (geometry/inlining.hpp).
[[nodiscard]] std::vector<Violation> own_flattening(const std::vector<SourceFile>& files);

/// Source files that a comment names and the tree does not have.
[[nodiscard]] std::vector<Violation> dead_mentions(const std::vector<SourceFile>& files);

[[nodiscard]] std::vector<Violation> long_readme(const std::vector<SourceFile>& files);

[[nodiscard]] std::vector<Violation> long_classes(const std::vector<SourceFile>& files);

}  // namespace edgewise::house
