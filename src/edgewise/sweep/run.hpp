// SPDX-License-Identifier: MIT
//
// Runs a plan's work into a store: every cell verified, then measured in interleaved rounds. Rounds already
// stored for this build are kept; missing ones are run with the baseline timed again beside them.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "edgewise/store/store.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

struct SweepSummary {
    std::size_t cells = 0, verified = 0, failed = 0, unavailable = 0;
    std::size_t judged = 0;  ///< of other libraries, and of raw V-Clip
    bool stopped = false;    ///< before the end; what is stored stays
};

/// What a sweep tells while it runs.
struct SweepListener {
    /// How much work there will be, in expected seconds, and how many cells.
    std::function<void(double work, std::size_t cells)> on_start;
    /// That much more is done; cells as their group ends.
    std::function<void(double work, std::size_t cells, const std::string& what)> on_done;
    /// Likewise, by an earlier run.
    std::function<void(double work, std::size_t cells)> on_resumed;
    std::function<void(const std::string& line)> on_warning;
};

/// `stop` is looked at between rounds.
[[nodiscard]] SweepSummary run_sweep(const SweepWork& work, store::Store& store,
                                     const SweepListener& listener, const std::atomic<bool>& stop);

}  // namespace edgewise::sweep
