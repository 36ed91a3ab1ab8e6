// SPDX-License-Identifier: MIT
//
// The queries of a workload once more, through tables that report what is read of them; and what a query
// reads and writes of its pair's cache, and a frame's broad phase of its arrays. Answers are those of the
// plain tables.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/trace/frame_trace.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// Sets the step that reads are booked under: of V-Clip the state, of GJK the iterations.
struct StepMarks {
    measure::TraceSink &a, &b;

    void visit(FeatureKind kind_a, FeatureKind kind_b) const { set(step_of(kind_a, kind_b)); }
    void ask_gjk() const { set(TraceStep::settle); }
    void iterate(std::uint8_t /*members*/) const { set(TraceStep::gjk_iteration); }
    void set(TraceStep step) const {
        a.set_step(static_cast<std::uint8_t>(step));
        b.set_step(static_cast<std::uint8_t>(step));
    }
};

/// Views of two tables, and their pair cache. TracedTable: the table's layout with a loader that tells a
/// TraceSink.
template <class Algorithm, class TracedTable>
struct TracedPair {
    TracedTable a, b;
    typename Algorithm::template Pair<TracedTable, TracedTable> pair;

    template <class Table>
    TracedPair(const Table& table_a, const Table& table_b, measure::TraceSink& sink_a,
               measure::TraceSink& sink_b)
        : a(table_a, {&sink_a}), b(table_b, {&sink_b}), pair(a, b) {}
};

/// Notifies the listener of the first queries, until so many have counted. tables(query) gives a query's two
/// tables. Tables are only read, and pairs read first and written last. `answers` may be null.
template <class Algorithm, class TracedTable, class Tables>
PassSum trace_queries(const scene::Workload& workload, std::size_t limit, const QueryOptions& options,
                      const TracePlaces& places, Tables tables, measure::TraceListener& listener,
                      Distance* answers) {
    const std::vector<std::uint8_t> cold = cold_starts(workload);
    measure::TraceSink sink_a(listener, measure::TraceSide::table_a, places.base);
    measure::TraceSink sink_b(listener, measure::TraceSide::table_b, places.base);
    const StepMarks marks{sink_a, sink_b};
    const auto touch_pair = [&](std::uint32_t pair, measure::AccessKind kind) {
        if (!workload.warm) return;
        listener.on_access({places.pair_caches + std::uint64_t{pair} * places.pair_bytes, places.pair_bytes,
                            kind, pair_cache_field, static_cast<std::uint8_t>(TraceStep::pair_cache),
                            measure::TraceSide::scene});
    };
    std::unordered_map<std::uint32_t, std::unique_ptr<TracedPair<Algorithm, TracedTable>>> pairs;
    FrameTrace frames(workload, places, listener);
    std::size_t counted = 0;
    PassSum sum;
    for (std::size_t i = 0; i < cold.size() && counted < limit; ++i) {
        const scene::Query& query = workload.queries[i];
        frames.before(i);
        const auto [table_a, table_b] = tables(query);
        auto& traced = pairs[query.pair];
        if (!traced || !workload.warm)
            traced = std::make_unique<TracedPair<Algorithm, TracedTable>>(*table_a, *table_b, sink_a, sink_b);
        touch_pair(query.pair, measure::AccessKind::read);
        marks.set(TraceStep::start);
        const Transform<double> a_from_b = relative_pose(query.pose_a, query.pose_b);
        const Distance answer =
            Algorithm::query(traced->a, traced->b, a_from_b, traced->pair, options, marks);
        if (answers) answers[i] = answer;
        sum.distances += answer.distance;
        ++sum.queries;
        touch_pair(query.pair, measure::AccessKind::write);
        listener.on_query_end(!cold[i]);
        counted += !cold[i];
    }
    frames.end();
    return sum;
}

}  // namespace edgewise::bench
