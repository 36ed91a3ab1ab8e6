// SPDX-License-Identifier: MIT
//
// A pair of bodies as bytes, so that small changes by a fuzzer are small changes of the pair: two counts, a
// form, then doubles as in memory. With the first form, rotations are nine doubles as in a case, and must be
// nearly orthogonal; with the second, quaternions of four small whole numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "edgewise/scene/case_file.hpp"

namespace edgewise {

/// Returns no value if a number is not finite or a matrix is not a rotation.
[[nodiscard]] std::optional<scene::Case> pair_from_bytes(std::span<const std::uint8_t> bytes);

/// Returns no value if the case has more vertices than the format holds. Given faces are left out.
[[nodiscard]] std::optional<std::vector<std::uint8_t>> bytes_from_pair(const scene::Case& given);

}  // namespace edgewise
