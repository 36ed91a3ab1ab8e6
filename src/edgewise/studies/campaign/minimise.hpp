// SPDX-License-Identifier: MIT
//
// A failing pair made small: fewer vertices, plainer poses, rounder numbers, as long as it still fails. Delta
// debugging (Zeller and Hildebrandt, 2002) of one vertex at a time, since a body has a few dozen that matter.
#pragma once

#include <cstddef>
#include <functional>

#include "edgewise/scene/case_file.hpp"

namespace edgewise::studies::campaign {

/// Whether a case still fails; false for what is no case (bodies that no hull takes).
using Fails = std::function<bool(const scene::Case&)>;

/// Asks at most `budget` times. The result fails if the given case did.
[[nodiscard]] scene::Case minimised(const scene::Case& given, const Fails& fails,
                                    std::size_t budget = 20'000);

}  // namespace edgewise::studies::campaign
