// SPDX-License-Identifier: MIT
//
// All runs of a plan into one store, with progress on stderr: its comparisons, then the hard families,
// paging, what made figure 8, and effort. Ctrl-C stops after the piece in hand.
#pragma once

#include "edgewise/studies/stability.hpp"
#include "edgewise/sweep/run.hpp"

namespace edgewise::cli {

struct SweepOutcome {
    sweep::SweepSummary sweep;
    studies::StabilitySummary stability;
    bool stopped = false;  ///< before the end; what is stored stays
};

[[nodiscard]] SweepOutcome run_all(const sweep::SweepWork& work, store::Store& store);

}  // namespace edgewise::cli
