// SPDX-License-Identifier: MIT
//
// The corpus: case files of pairs on which some collision library was wrong, crashed or did not end, each
// with its source; and the same pairs seen otherwise (swapped, listed backwards, scaled, turned, moved).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/scene/case_file.hpp"

namespace edgewise {

/// All cases of all files in the corpus folder, in the order of files and lines.
[[nodiscard]] const std::vector<scene::Case>& corpus();

[[nodiscard]] scene::Case swapped(const scene::Case& given);

/// Every vertex list backwards, faces renumbered to match.
[[nodiscard]] scene::Case reversed(const scene::Case& given);

/// The whole scene times 2^exponent.
[[nodiscard]] scene::Case scaled_by_power(const scene::Case& given, int exponent);

/// How many rotations by quarter turns there are, the identity (number 0) among them.
inline constexpr int quarter_turns = 24;

/// The whole scene turned by one of them: coordinates change places and signs, none is rounded.
[[nodiscard]] scene::Case turned(const scene::Case& given, int turn);

/// The whole scene moved, along every axis by the longest power of two, up to 2^30 of the translations' own
/// length, that rounds neither of them; nothing where no axis has one.
[[nodiscard]] std::optional<scene::Case> moved_exactly(const scene::Case& given);

}  // namespace edgewise
