// SPDX-License-Identifier: MIT
//
// The corpus: case files of pairs on which some collision library was wrong, crashed or did not end, each
// with its source; and transformations of a pair (swapped, vertices reversed, scaled, turned, moved).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edgewise/scene/case_file.hpp"

namespace edgewise {

/// All cases of all files in the corpus folder, in the order of files and lines.
[[nodiscard]] const std::vector<scene::Case>& corpus();

[[nodiscard]] scene::Case swapped(const scene::Case& given);

/// Reverses every vertex list, and renumbers faces to match.
[[nodiscard]] scene::Case reversed(const scene::Case& given);

/// Scales the whole scene by 2^exponent.
[[nodiscard]] scene::Case scaled_by_power(const scene::Case& given, int exponent);

/// Number of rotations by quarter turns, with the identity (number 0).
inline constexpr int quarter_turns = 24;

/// Turns the whole scene by quarter turns: coordinates change places and signs, without rounding.
[[nodiscard]] scene::Case turned(const scene::Case& given, int turn);

/// Moves the whole scene along every axis by the longest power of two, up to 2^30 of the translations' own
/// length, that rounds neither translation; no value if no axis has such a power.
[[nodiscard]] std::optional<scene::Case> moved_exactly(const scene::Case& given);

}  // namespace edgewise
