// SPDX-License-Identifier: MIT
//
// Work on a file that somebody else's parser does: in a child process, under limits. A parser that runs in
// circles, eats memory or crashes ends the child and not the program.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "edgewise/geometry/result.hpp"

namespace edgewise::input {

struct GuardLimits {
    std::uint64_t memory_bytes = 0;     ///< beyond what this process has mapped already
    std::chrono::milliseconds time{0};  ///< by the clock
};

/// What `work` returns in a child, as bytes. Fails when the child took longer or more memory than allowed, or
/// was ended by a signal, with one line that says which. What `work` throws but std::bad_alloc is its own to
/// catch. Call it where no other thread runs that holds locks which `work` takes.
[[nodiscard]] Result<std::string> run_guarded(const std::function<std::string()>& work,
                                              const GuardLimits& limits);

}  // namespace edgewise::input
