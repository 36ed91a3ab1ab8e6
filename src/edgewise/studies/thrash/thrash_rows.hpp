// SPDX-License-Identifier: MIT
//
// The study of figure 8 as rows of the store. Scene `thrash`: a row for each mechanism, table type, sharing,
// time step and machine; scene `thrash_realised`: a row for each curve of a cell made real.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "edgewise/studies/thrash/factorial.hpp"

namespace edgewise::studies::thrash {

// Measures a cell of the factorial for real, as figure 8: time against speed, both algorithms, 38 and 386
// vertices, on this machine. The tables are in a memory of the cell's size; a page that is not in it arrives
// after the cell's cost of a fault (fault_pager.hpp). Each time has a prediction: the same queries
// without the pager, and the faults that the same policy has on the pages of a trace.

struct RealisedPoint {
    double speed = 0;  ///< rad per second
    std::uint64_t queries = 0;
    double in_memory_ns = 0;  ///< per query, without the pager
    /// Per query. A soft fault maps a page that is in memory.
    double predicted_faults = 0, predicted_soft_faults = 0, faults = 0, soft_faults = 0;
    double fault_overhead_ns = 0;  ///< of any fault beyond its wait, as the filling steps had it
    double predicted_ns = 0, measured_ns = 0;
    double model_ns = 0;        ///< of the factorial, with a processor of the time
    bool same_answers = false;  ///< to the last bit, with and without the pager
};

struct RealisedCurve {
    std::string shape, algorithm;
    std::vector<RealisedPoint> points;
};

struct RealisedCell {
    Setting setting;
    std::vector<RealisedCurve> curves;
    std::string reason, remedy;  ///< why there are none

    /// Returns the largest quotient, over all points, of measured and predicted time, in either direction.
    [[nodiscard]] double worst_ratio() const;
};

/// Returns the outcomes to make real: for each cost of a fault, with queries alone, the one with most facts
/// and the rise nearest to the paper's 12 (on the first machine). The best `count` of them are kept.
[[nodiscard]] std::vector<Outcome> outcomes_to_realise(const Factorial& factorial, std::size_t count);

/// `budget_ns`: waiting time for each point. If all counted steps would take longer, fewer queries are
/// asked.
[[nodiscard]] RealisedCell realise(const Outcome& outcome, const Levels& levels, double budget_ns);

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
