// SPDX-License-Identifier: MIT
//
// Runs another library's parser in a child process, under limits. A parser that never ends, takes too much
// memory or crashes ends the child and not the program.
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

/// The bytes that `work` returns in a child. Fails with one line if the child took longer or more memory than
/// allowed, or was ended by a signal. `work` must catch what it throws, except std::bad_alloc. No other
/// thread may hold locks that `work` takes.
[[nodiscard]] Result<std::string> run_guarded(const std::function<std::string()>& work,
                                              const GuardLimits& limits);

}  // namespace edgewise::input
