// SPDX-License-Identifier: MIT
//
// Ctrl-C or SIGTERM: long work ends after the piece in hand.
#pragma once

#include <atomic>
#include <csignal>

namespace edgewise::cli {

inline std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

inline const std::atomic<bool>& stop_on_signals() {
    std::signal(SIGINT, [](int) { stop_requested = true; });
    std::signal(SIGTERM, [](int) { stop_requested = true; });
    return stop_requested;
}

}  // namespace edgewise::cli
