// SPDX-License-Identifier: MIT
//
// The message of an exception, for tests of what users read.
#pragma once

#include <stdexcept>
#include <string>

namespace edgewise {

/// Returns the message of the Problem that `action` throws; empty if it throws nothing. Others pass through.
template <class Problem = std::runtime_error, class Action>
[[nodiscard]] std::string complaint_of(Action action) {
    try {
        static_cast<void>(action());
    } catch (const Problem& problem) {
        return problem.what();
    }
    return {};
}

}  // namespace edgewise
