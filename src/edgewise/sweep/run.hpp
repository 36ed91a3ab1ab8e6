// SPDX-License-Identifier: MIT
//
// Runs a plan's work into a store: verifies every cell, then measures the cells in interleaved rounds. Rounds
// already stored for this build are kept; in a missing round the baseline is timed again with the cells.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "edgewise/store/store.hpp"
#include "edgewise/sweep/expected_work.hpp"
#include "edgewise/sweep/prepared_cell.hpp"
#include "edgewise/sweep/work.hpp"

namespace edgewise::sweep {

struct SweepSummary {
    std::size_t cells = 0, verified = 0, failed = 0, unavailable = 0;
    std::size_t judged = 0;  ///< cells of other libraries, and of raw V-Clip
    bool stopped = false;    ///< ended early; stored results are kept
};

/// Functions that a sweep calls while it runs.
struct SweepListener {
    /// Called when more work is done; `cells` is 0 until their group ends.
    std::function<void(std::size_t cells, const std::string& what)> on_done;
    /// Called for cells that an earlier run measured.
    std::function<void(std::size_t cells)> on_resumed;
    std::function<void(const std::string& line)> on_warning;
};

/// What all cells of a scene on a shape have in common: a row without algorithm, table and hash.
[[nodiscard]] store::CellRow row_of(const Plan& plan, const SceneWork& scene, const scene::NamedShape& shape);
/// The queries that all cells of a scene on a shape answer. Throws std::invalid_argument when the scene
/// cannot be made.
[[nodiscard]] SharedQueries queries_of(Plan plan, const SceneWork& scene, const scene::NamedShape& shape);

/// `left` receives the expected work and the time that each part took. `stop` is read between rounds.
[[nodiscard]] SweepSummary run_sweep(const SweepWork& work, store::Store& store, TimeLeft& left,
                                     const SweepListener& listener, const std::atomic<bool>& stop);

}  // namespace edgewise::sweep
