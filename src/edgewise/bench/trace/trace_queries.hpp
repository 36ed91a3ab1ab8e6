// SPDX-License-Identifier: MIT
//
// The queries of a workload once more, through tables that report what is read of them; and what a query
// reads and writes of its pair's cache, and a frame's broad phase of its arrays. Answers are those of the
// plain tables.
#pragma once

#include <memory>
#include <unordered_map>
#include <vector>

#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/trace/frame_trace.hpp"
#include "edgewise/bench/trace/trace_extent.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/bench/trace/traced_question.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// Notifies the listener of the queries of that extent. tables(query) gives a query's two
/// tables. Tables are only read; of a pair's cache as much is read and written as the question does.
/// `answers` may be null.
template <class Algorithm, class TracedTable, class Tables>
PassSum trace_queries(const scene::Workload& workload, const TraceExtent& extent,
                      const TracedQuestion& question, const TracePlaces& places, Tables tables,
                      measure::TraceListener& listener, Distance* answers) {
    const std::vector<std::uint8_t> cold = cold_starts(workload);
    measure::TraceSink sink_a(listener, measure::TraceSide::table_a, places.base);
    measure::TraceSink sink_b(listener, measure::TraceSide::table_b, places.base);
    const StepMarks marks{sink_a, sink_b, listener};
    std::unordered_map<std::uint32_t, std::unique_ptr<TracedPair<Algorithm, TracedTable>>> pairs;
    FrameTrace frames(workload, places, listener);
    const std::size_t least = extent.end_of_steps(workload);
    std::size_t counted = 0;
    PassSum sum;
    for (std::size_t i = 0; i < cold.size() && (counted < extent.counted || i < least); ++i) {
        const scene::Query& query = workload.queries[i];
        frames.before(i);
        if (query.pair % extent.pair_stride != 0) continue;
        listener.on_query_start(workload.warm && !cold[i] ? measure::QueryStart::warm
                                                          : measure::QueryStart::cold);
        const auto [table_a, table_b] = tables(query);
        auto& traced = pairs[query.pair];
        if (!traced || !workload.warm)
            traced = std::make_unique<TracedPair<Algorithm, TracedTable>>(*table_a, *table_b, sink_a, sink_b);
        const PairTouch touch{listener, places, query.pair, workload.warm};
        const Distance answer = question.ask(query, *traced, marks, touch);
        if (answers) answers[i] = answer;
        sum.distances += answer.distance;
        ++sum.queries;
        listener.on_query_end(!cold[i]);
        counted += !cold[i];
    }
    frames.end();
    return sum;
}

}  // namespace edgewise::bench
