// SPDX-License-Identifier: MIT
//
// The message of an exception, for tests of what users read.
#pragma once

#include <exception>
#include <string>

namespace edgewise {

/// The message of the std::exception that `action` throws; empty if it throws none.
template <class Action>
[[nodiscard]] std::string complaint_of(Action action) {
    try {
        static_cast<void>(action());
    } catch (const std::exception& problem) {
        return problem.what();
    }
    return {};
}

}  // namespace edgewise
