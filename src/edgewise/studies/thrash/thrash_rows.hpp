// SPDX-License-Identifier: MIT
//
// The study of figure 8 as rows of the store. Scene `thrash`: a row for each mechanism, table type, sharing,
// time step and machine; scene `thrash_realised`: a row for each curve of a cell made real.
#pragma once

#include <cstddef>
#include <vector>

#include "edgewise/studies/thrash/factorial.hpp"
#include "edgewise/studies/thrash/realised_cell.hpp"

namespace edgewise::studies::thrash {

/// Number of the factorial's cells that are made real, and the longest wait of each of their points.
inline constexpr std::size_t realised_cells = 3;
inline constexpr double budget_of_a_point_ns = 3e9;

/// The outcomes of one row: all of its bodies, memories and costs.
struct OutcomeGroup {
    Setting setting;  ///< bodies, memory and cost are nothing here
    std::vector<const Outcome*> outcomes;

    [[nodiscard]] std::size_t with(Fact fact) const;
    [[nodiscard]] std::size_t with_all() const;
    /// Returns the outcome with most facts; among equal outcomes, the one with the rise nearest to 12.
    [[nodiscard]] const Outcome& best() const;
};

[[nodiscard]] std::vector<OutcomeGroup> groups_of(const Factorial& factorial);

}  // namespace edgewise::studies::thrash
