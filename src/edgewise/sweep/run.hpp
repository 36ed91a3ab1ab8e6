// SPDX-License-Identifier: MIT
//
// Runs a plan's work into a store: every cell verified, then measured in interleaved rounds. Rounds already
// stored for this build are kept; missing ones are run with the baseline timed again beside them.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "edgewise/store/store.hpp"
#include "edgewise/sweep/expected_work.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

struct SweepSummary {
    std::size_t cells = 0, verified = 0, failed = 0, unavailable = 0;
    std::size_t judged = 0;  ///< of other libraries, and of raw V-Clip
    bool stopped = false;    ///< before the end; what is stored stays
};

/// What a sweep tells while it runs.
struct SweepListener {
    /// More work is done; cells as their group ends.
    std::function<void(std::size_t cells, const std::string& what)> on_done;
    /// Cells that an earlier run measured.
    std::function<void(std::size_t cells)> on_resumed;
    std::function<void(const std::string& line)> on_warning;
};

/// `left` learns what there is to do and how long it takes. `stop` is looked at between rounds.
[[nodiscard]] SweepSummary run_sweep(const SweepWork& work, store::Store& store, TimeLeft& left,
                                     const SweepListener& listener, const std::atomic<bool>& stop);

}  // namespace edgewise::sweep
