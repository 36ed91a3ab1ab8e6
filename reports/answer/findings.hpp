// SPDX-License-Identifier: MIT
//
// What a reader should look at, with what it would save, and what passed: from the answer alone.
#pragma once

#include <string>
#include <vector>

#include "edgewise/reports/answer/answer.hpp"

namespace edgewise::reports {

/// Returns the findings: largest savings, then changes of the answer, then missing figures and a remedy.
[[nodiscard]] std::vector<std::string> what_to_look_at(const Answer& answer);

[[nodiscard]] std::vector<std::string> what_passed(const Answer& answer);

}  // namespace edgewise::reports
