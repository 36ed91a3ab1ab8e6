// SPDX-License-Identifier: MIT
//
// The queries of a workload once more, through tables that report what is read of them; and what a query
// reads and writes of its pair's cache, and a frame's broad phase of its arrays. Answers are those of the
// plain tables. A query is asked as a pass asks it: for what the options need, or for nearness, where a
// pair's bounds may answer and nothing but them is read.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "edgewise/algorithms/near_pair.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/rounded.hpp"
#include "edgewise/bench/near_question.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/trace/frame_trace.hpp"
#include "edgewise/bench/trace/trace_extent.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/bench/trace/trace_places.hpp"
#include "edgewise/measure/cache/trace.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// Sets the step that reads are booked under, and notifies the listener where each begins: states of V-Clip,
/// iterations of GJK.
struct StepMarks {
    measure::TraceSink &a, &b;
    measure::TraceListener& listener;

    void visit(FeatureKind kind_a, FeatureKind kind_b) const { set(step_of(kind_a, kind_b)); }
    void ask_gjk() const { set(TraceStep::settle); }
    void search() const { set(TraceStep::gjk_iteration); }
    void iterate(std::uint8_t /*members*/) const { set(TraceStep::gjk_iteration); }
    void set(TraceStep step) const {
        a.set_step(static_cast<std::uint8_t>(step));
        b.set_step(static_cast<std::uint8_t>(step));
        listener.on_step_start(static_cast<std::uint8_t>(step));
    }
};

/// Views of two tables, and their pair's cache. TracedTable: the table's layout with a loader that reports to
/// a TraceSink.
template <class Algorithm, class TracedTable>
struct TracedPair {
    using AlgorithmType = Algorithm;

    TracedTable a, b;
    NearCache<typename Algorithm::template Pair<TracedTable, TracedTable>> cache;  ///< bounds unused by most

    template <class Table>
    TracedPair(const Table& table_a, const Table& table_b, measure::TraceSink& sink_a,
               measure::TraceSink& sink_b)
        : a(table_a, {&sink_a}), b(table_b, {&sink_b}), cache{{}, {a, b}} {}
};

/// Tells of accesses to the start of one pair's cache, which only warm scenes keep.
struct PairTouch {
    measure::TraceListener& listener;
    const TracePlaces& places;
    std::uint32_t pair;
    bool warm;

    void operator()(std::uint32_t bytes, measure::AccessKind kind) const {
        if (!warm) return;
        listener.on_access({places.pair_caches + std::uint64_t{pair} * places.pair_bytes, bytes, kind,
                            pair_cache_field, static_cast<std::uint8_t>(TraceStep::pair_cache),
                            measure::TraceSide::scene});
    }
};

struct TracedQuestion {
    const QueryOptions& options;
    const NearMargins* near = nullptr;   ///< null: no margin is asked about
    std::span<const double> radii = {};  ///< of the instances; empty: none has one

    /// A pair's cache is read first and written last, completely unless its bounds decide.
    template <class Traced>
    [[nodiscard]] Distance ask(const scene::Query& query, Traced& traced, const StepMarks& marks,
                               const PairTouch& touch) const {
        using enum measure::AccessKind;
        const Transform<double> a_from_b = relative_pose(query.pose_a, query.pose_b);
        if (near && touch.warm) {
            if (const auto told = near->told_by(traced.cache.bounds, query, a_from_b)) {
                touch(sizeof(DistanceBounds), read);
                return near_answer(*told, near->margin(query));
            }
        }
        touch(touch.places.pair_bytes, read);
        marks.set(TraceStep::start);
        const Distance answer = ask_tables(query, traced, a_from_b, marks, touch.warm);
        touch(touch.places.pair_bytes, write);
        return answer;
    }

  private:
    template <class Traced>
    [[nodiscard]] Distance ask_tables(const scene::Query& query, Traced& traced,
                                      const Transform<double>& a_from_b, const StepMarks& marks,
                                      bool warm) const {
        using Algorithm = typename Traced::AlgorithmType;
        using Table = decltype(traced.a);
        auto& [a, b, cache] = traced;
        if (!radii.empty())
            return query_rounded<Algorithm>(Rounded<Table>{a, radii[query.instance_a]},
                                            Rounded<Table>{b, radii[query.instance_b]}, a_from_b, cache.pair,
                                            options, marks);
        if (!near) return Algorithm::query(a, b, a_from_b, cache.pair, options, marks);
        return ask_tables_near<Algorithm>(a, b, a_from_b, cache, warm, *near, query, options, marks);
    }
};

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
    std::size_t counted = 0, i = 0;
    PassSum sum;
    for (; i < cold.size() && (counted < extent.counted || i < least); ++i) {
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
    frames.end_before(i);
    return sum;
}

}  // namespace edgewise::bench
