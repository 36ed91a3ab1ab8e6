// SPDX-License-Identifier: MIT
//
// A program run to its end, and what it said.
#pragma once

#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

struct ProcessOutcome {
    int exit_code = 0;     ///< 128 and the signal when one ended it
    std::string out, err;  ///< all that it wrote
};

/// Found by PATH unless named with a slash. Unknown: it cannot be started.
[[nodiscard]] Expected<ProcessOutcome> run_program(const std::vector<std::string>& command);

}  // namespace edgewise::measure
