// SPDX-License-Identifier: MIT
//
// The queries of a workload once more, through tables that tell what is read of them.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/measure/lines_touched.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/sweep/cold_starts.hpp"

namespace edgewise {

/// Views of two tables, and their pair cache. TracedTable: the table's layout with a loader that tells a
/// LineSink.
template <class Algorithm, class TracedTable>
struct TracedPair {
    TracedTable a, b;
    typename Algorithm::template Pair<TracedTable, TracedTable> pair;

    template <class Table>
    TracedPair(const Table& table_a, const Table& table_b, LineSink& sink_a, LineSink& sink_b)
        : a(table_a, {&sink_a}), b(table_b, {&sink_b}), pair(a, b) {}
};

/// What the first queries read, so many at most; cold starts of a warm scene do not count. tables(query)
/// gives a query's two tables.
template <class Algorithm, class TracedTable, class Tables>
[[nodiscard]] LinesTouched trace_lines(const Workload& workload, std::size_t limit,
                                       const QueryOptions& options, Tables tables) {
    const std::vector<std::uint8_t> cold = cold_starts(workload);
    LinesTouched sum;
    LineSink sink_a, sink_b;
    std::unordered_map<std::uint32_t, std::unique_ptr<TracedPair<Algorithm, TracedTable>>> pairs;
    for (std::size_t i = 0; i < cold.size() && sum.queries < limit; ++i) {
        const Query& query = workload.queries[i];
        const auto [table_a, table_b] = tables(query);
        auto& traced = pairs[query.pair];
        if (!traced || !workload.warm) {
            traced = std::make_unique<TracedPair<Algorithm, TracedTable>>(*table_a, *table_b, sink_a, sink_b);
        }
        static_cast<void>(Algorithm::query(traced->a, traced->b, relative_pose(query.pose_a, query.pose_b),
                                           traced->pair, options));
        if (cold[i]) {
            sink_a.forget();
            sink_b.forget();
            continue;
        }
        sink_a.add_to(sum);
        sink_b.add_to(sum);
        ++sum.queries;
    }
    return sum;
}

}  // namespace edgewise
