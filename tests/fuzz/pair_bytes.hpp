// SPDX-License-Identifier: MIT
//
// A pair of bodies as bytes, so that a fuzzer's small changes are small changes of the pair: two counts, a
// form, then doubles as they lie in memory. The form says whether rotations are nine doubles (as cases give
// them; only what is nearly orthogonal is taken) or a quaternion of four small whole numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edgewise/scene/case_file.hpp"

namespace edgewise {

/// Nothing when the bytes are no pair: a number that is not finite, or no rotation.
[[nodiscard]] std::optional<scene::Case> pair_from_bytes(std::span<const std::uint8_t> bytes);

/// Nothing when the case has more vertices than a pair of bytes holds. Faces as given are left out.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytes_from_pair(const scene::Case& given);

}  // namespace edgewise
