// SPDX-License-Identifier: MIT
//
// Runs a program to its end and returns its output.
#pragma once

#include <string>
#include <vector>

#include "edgewise/measure/expected.hpp"

namespace edgewise::measure {

struct ProcessOutcome {
    int exit_code = 0;     ///< 128 and the signal when one ended it
    std::string out, err;  ///< all its output
};

/// Runs a command; the program is found by PATH unless its name has a slash. Refused if it cannot be started.
[[nodiscard]] Expected<ProcessOutcome> run_program(const std::vector<std::string>& command);

}  // namespace edgewise::measure
