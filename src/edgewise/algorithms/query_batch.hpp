// SPDX-License-Identifier: MIT
//
// Many pairs at once: queries in, answers out, each to the bit that of a single query. GJK's pairs of small
// bodies go side by side (gjk_batch.hpp). Pairs of other tables, pairs of V-Clip, which each walk their own
// way, and pairs that Johnson's search solves go one after the other.
#pragma once

#include <cassert>
#include <span>
#include <type_traits>

#include "edgewise/algorithms/gjk_batch.hpp"
#include "edgewise/algorithms/lanes/lane_width.hpp"
#include "edgewise/algorithms/pair_query.hpp"
#include "edgewise/algorithms/sub_distance_solver.hpp"

namespace edgewise {

/// Answers queries[i] in answers[i]. Disjoint parts of a batch may run in threads of their own: they share
/// only tables, which are read (parallel_batch.hpp). V-Clip has no lanes, and ignores the width.
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
