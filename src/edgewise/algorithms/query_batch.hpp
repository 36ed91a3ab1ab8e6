// SPDX-License-Identifier: MIT
//
// Many pairs at once: queries in, answers out, each to the bit that of a single query. GJK's pairs of small
// bodies go side by side (gjk_batch.hpp); those of other tables, and V-Clip's, which walk each a way of its
// own, one after the other; so are those that Johnson's search is to solve.
#pragma once

#include <cassert>
#include <span>
#include <type_traits>

#include "edgewise/algorithms/gjk_batch.hpp"
#include "edgewise/algorithms/lanes/lane_width.hpp"
#include "edgewise/algorithms/pair_query.hpp"
#include "edgewise/algorithms/sub_distance_solver.hpp"

namespace edgewise {

/// Answers queries[i] in answers[i]. Disjoint parts of a batch may run in as many threads: nothing is shared
/// but tables, which are read (parallel_batch.hpp). V-Clip has no lanes, and no use for a width.
template <SupportTable TableA, SupportTable TableB, class Algorithm = Gjk>
void query_batch(PairQueries<TableA, TableB, Algorithm> queries, std::span<Distance> answers,
                 const QueryOptions& options = {}, LaneWidth width = best_lanes()) {
    assert(queries.size() == answers.size());
    if constexpr (std::is_same_v<Algorithm, Gjk> && LaneTable<TableA> && LaneTable<TableB>) {
        const bool by_cofactors = options.sub_distance == SubDistanceSolver::cofactors;
        if (by_cofactors && width != LaneWidth::none)
            return GjkBatch<TableA, TableB>(queries, answers, options).run(width);
    }
    ask_in_order(queries, answers, options);
}

}  // namespace edgewise
