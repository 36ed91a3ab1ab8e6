// SPDX-License-Identifier: MIT
//
// The study of figure 8 as rows of the store. Scene `thrash`: a row for each mechanism, table type, sharing,
// time step and machine; scene `thrash_realised`: a row for each curve of a cell made real.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "edgewise/store/store.hpp"
#include "edgewise/studies/thrash/factorial.hpp"
#include "edgewise/studies/thrash/realised_cell.hpp"

namespace edgewise::studies::thrash {

/// How many cells of a factorial are made real, and for how long each of their points may wait.
inline constexpr std::size_t realised_cells = 3;
inline constexpr double budget_of_a_point_ns = 3e9;

/// The outcomes of one row: all of its bodies, memories and costs.
struct OutcomeGroup {
    Setting setting;  ///< bodies, memory and cost are nothing here
    std::vector<const Outcome*> outcomes;

    [[nodiscard]] std::size_t with(Fact fact) const;
    [[nodiscard]] std::size_t with_all() const;
    /// Returns the outcome with most facts; among equals the one that rises nearest to 12.
    [[nodiscard]] const Outcome& best() const;
};

[[nodiscard]] std::vector<OutcomeGroup> groups_of(const Factorial& factorial);

/// Returns true if this program has the table types of the levels.
[[nodiscard]] bool has_tables(const Levels& levels);

/// Traces, scores, makes the best cells real and stores all of it, unless the build's rows are there.
/// `on_scene` is notified of each traced scene and each realised cell. False when it was stopped.
[[nodiscard]] bool run_thrash(const Levels& levels, const std::string& build, store::Store& store,
                              const std::function<void()>& on_scene, const std::atomic<bool>& stop);

/// How many notifications that makes.
[[nodiscard]] std::size_t thrash_units(const Levels& levels);

}  // namespace edgewise::studies::thrash
