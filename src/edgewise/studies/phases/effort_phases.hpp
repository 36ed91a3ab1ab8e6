// SPDX-License-Identifier: MIT
//
// The effort of one cell's queries (effort.hpp) divided by phase (phases.hpp): counted in the same region, as
// the same difference of passes, by the same Callgrind; only asked where every instruction came from.
#pragma once

#include <string>
#include <vector>

#include "edgewise/studies/effort.hpp"
#include "edgewise/studies/effort_rows.hpp"
#include "edgewise/studies/phases/phase_counts.hpp"

namespace edgewise::studies {

/// Means per query over all queries of the scene.
struct PhaseEffort {
    std::string phase;
    double instructions = 0, mispredictions = 0, d1_misses = 0;
    double instructions_in_steps = 0;  ///< the others: once a query
};

struct EffortByPhase {
    std::string table, algorithm;
    std::string wrong;                ///< of checked answers, or of the phases' sum; empty: nothing
    std::string reason, remedy;       ///< why there are no phases
    double steps = 0;                 ///< V-Clip states or GJK iterations per query
    std::vector<PhaseEffort> phases;  ///< those that take most instructions first; empty: `reason`
    std::vector<std::string> others;  ///< the files and functions that take most of `other`, up to three
    PhaseEffort total;                ///< as Callgrind has it, not added up; of `in_steps` the sum
};

/// One pass of two runs' phases, of `few` and of `many` passes, divided by the passes and queries between
/// them.
[[nodiscard]] std::vector<PhaseEffort> phases_per_query(const PhaseCounts& few, const PhaseCounts& many,
                                                        int passes, double queries);

/// Of our table types in the plan, in its order; its peers are left out. Throws as `examine` does.
[[nodiscard]] std::vector<EffortByPhase> effort_by_phase(const EffortPlan& plan);

}  // namespace edgewise::studies
