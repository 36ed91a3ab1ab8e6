// SPDX-License-Identifier: MIT
//
// What a reader should look at, with what it would save, and what passed: from the answer alone.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

/// Largest savings first, then what would change the answer, then what was not measured and how to get it.
[[nodiscard]] std::vector<std::string> what_to_look_at(const Answer& answer);

[[nodiscard]] std::vector<std::string> what_passed(const Answer& answer);

}  // namespace edgewise::reports
