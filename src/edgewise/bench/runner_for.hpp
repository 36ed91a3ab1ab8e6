// SPDX-License-Identifier: MIT
//
// The runner of one algorithm on one table type. Included by the generated registry units only, so that
// layouts compile by themselves, in parallel.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/rounded.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/bench/batch_pass.hpp"
#include "edgewise/bench/frame_batches.hpp"
#include "edgewise/bench/name_answer.hpp"
#include "edgewise/bench/near_question.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/bench/scales/scale_study.hpp"
#include "edgewise/bench/support_times.hpp"
#include "edgewise/bench/table_runner.hpp"
#include "edgewise/bench/trace/trace_queries.hpp"

namespace edgewise::bench {

/// Caches of the pairs of a warm scene, each on its own bodies' tables. tables: gives a query's two.
template <class Pair, class Tables>
[[nodiscard]] std::vector<Pair> cold_pairs_of(const scene::Workload& workload, const Tables& tables) {
    if (!workload.warm || workload.queries.empty()) return {};
    const auto cold_pair = [&](const scene::Query& query) {
        const auto [a, b] = tables(query);
        return Pair(*a, *b);
    };
    std::vector<Pair> pairs(workload.pair_count, cold_pair(workload.queries.front()));
    for (const scene::Query& query : workload.queries) pairs[query.pair] = cold_pair(query);
    return pairs;
}

/// TracedTable: the same layout with a loader that reports to a TraceSink.
template <class Algorithm, class Table, class TracedTable>
class RunnerFor final : public TableRunner<Table> {
    using Base = TableRunner<Table>;
    using Base::asks_nearness, Base::in_range, Base::margins, Base::options, Base::prepared, Base::table_a,
        Base::radii, Base::table_allocator, Base::table_b, Base::tables;

  public:
    using Pair = typename Algorithm::template Pair<Table, Table>;

    RunnerFor() : Base(Algorithm::parts) {}

    using Runner::answer, Runner::trace;
    using typename Runner::RangePass;

    [[nodiscard]] NamedAnswer answer(const scene::Query& given) const override {
        const scene::Query query = prepared().prepared(given);
        if (!in_range(query)) return {};
        Pair pair = cold_pair(query);
        NamedAnswer result;
        name_answer(asked(query), pair, ask_plain(query, pair), Needs::depth, result);
        return prepared().scale().back(std::move(result));
    }

    [[nodiscard]] RangePass prepared_range() const override {
        if (asks_nearness()) return near_pass();
        if (options().batch) return batches_of(prepared().workload());
        if (!radii().empty())
            return pass_of(
                [this](const scene::Query& query, Pair& pair) { return ask_rounded(query, pair); });
        return pass_of([this](const scene::Query& query, Pair& pair) { return ask(query, pair); });
    }

    [[nodiscard]] RangePass batches_of(const scene::Workload& workload) const override {
        const auto pay = [this](const scene::Query& query, const Pair& pair, const Distance& answer) {
            pay_for_needs(query, pair, answer);
        };
        return BatchPass<Algorithm, Table, decltype(tables_of_queries()), decltype(pay)>(
            workload, options().query, tables_of_queries(), pay,
            cold_pairs_of<Pair>(workload, tables_of_queries()));
    }

    [[nodiscard]] std::unique_ptr<ThreadedPass> prepared_frames() const override {
        return frame_batches<Algorithm, Table>(prepared().workload(), options().query, tables_of_queries());
    }

    PassSum trace(const TraceExtent& extent, measure::TraceListener& listener,
                  Distance* answers) const override {
        const scene::Workload& workload = prepared().workload();
        const TracePlaces places(table_allocator().base(), table_allocator().taken(),
                                 static_cast<std::uint32_t>(pair_bytes()), workload.pair_count,
                                 workload.instances.size());
        return prepared().scale().back(trace_queries<Algorithm, TracedTable>(
            workload, extent, {options().query, asks_nearness() ? &margins() : nullptr, radii()}, places,
            tables_of_queries(), listener, answers));
    }

    [[nodiscard]] SupportTimes support_times(int n) const override {
        return time_supports<Algorithm>(tables(), n);
    }
    [[nodiscard]] ScaleTimes scale_times(int n) const override {
        return time_scales<Algorithm, Table>(prepared().bodies()[0], n);
    }

    [[nodiscard]] std::size_t pair_bytes() const override {
        return asks_nearness() ? sizeof(NearCache<Pair>) : sizeof(Pair);
    }

  private:
    /// Gives a query's two tables.
    [[nodiscard]] auto tables_of_queries() const {
        return [this](const scene::Query& query) {
            return std::pair(&tables()[table_a(query)], &tables()[table_b(query)]);
        };
    }

    [[nodiscard]] RangePass near_pass() const {
        return NearPass<Algorithm, Table, decltype(tables_of_queries())>(
            prepared().workload(), margins(), options().query, tables_of_queries(), cold_pairs());
    }

    [[nodiscard]] Pair cold_pair(const scene::Query& query) const {
        return Pair(tables()[table_a(query)], tables()[table_b(query)]);
    }

    [[nodiscard]] std::vector<Pair> cold_pairs() const {
        return cold_pairs_of<Pair>(prepared().workload(), tables_of_queries());
    }

    /// A pass by a function that answers one query from its pair.
    template <class Ask>
    [[nodiscard]] RangePass pass_of(const Ask& ask) const {
        const std::vector<Pair> cold = cold_pairs();
        return
            [this, ask, cold, pairs = cold](std::size_t first, std::size_t last, Distance* answers) mutable {
                if (first == 0) std::copy(cold.begin(), cold.end(), pairs.begin());
                return run(first, last, ask, pairs, answers);
            };
    }

    /// Queries first .. last - 1; the sum of their distances.
    template <class Ask>
    double run(std::size_t first, std::size_t last, const Ask& ask, std::vector<Pair>& pairs,
               Distance* answers) const {
        const scene::Workload& workload = prepared().workload();
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            const scene::Query& query = workload.queries[i];
            const auto ask_cold = [&] {
                Pair pair = cold_pair(query);
                return ask(query, pair);
            };
            const Distance answer = workload.warm ? ask(query, pairs[query.pair]) : ask_cold();
            if (answers) answers[i] = answer;
            sum += answer.distance;
        }
        return sum;
    }

    [[nodiscard]] Distance ask_plain(const scene::Query& query, Pair& pair) const {
        return Algorithm::query(tables()[table_a(query)], tables()[table_b(query)],
                                relative_pose(query.pose_a, query.pose_b), pair, options().query);
    }

    [[nodiscard]] Distance ask_rounded(const scene::Query& query, Pair& pair) const {
        return query_rounded<Algorithm>(Rounded<Table>{tables()[table_a(query)], radii()[query.instance_a]},
                                        Rounded<Table>{tables()[table_b(query)], radii()[query.instance_b]},
                                        relative_pose(query.pose_a, query.pose_b), pair, options().query);
    }

    [[nodiscard]] Distance ask(const scene::Query& query, Pair& pair) const {
        const Distance answer = ask_plain(query, pair);
        pay_for_needs(query, pair, answer);
        return answer;
    }

    void pay_for_needs(const scene::Query& query, const Pair& pair, const Distance& answer) const {
        if (options().needs > Needs::witnesses)
            pay_for_more(asked(query), pair, answer, options().needs, prepared().bodies());
    }

    [[nodiscard]] AskedPair<Table> asked(const scene::Query& query) const {
        return {tables()[table_a(query)], tables()[table_b(query)], prepared().bodies()[query.body_a],
                prepared().bodies()[query.body_b], query};
    }
};

}  // namespace edgewise::bench
