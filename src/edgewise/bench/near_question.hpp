// SPDX-License-Identifier: MIT
//
// A query with one question: are the bodies nearer to each other than a margin, and if so, how near? A pair
// of a warm scene answers by its bounds where these decide; else the tables compute the whole distance, which
// renews the bounds. A cold query has no past: the tables compute the distance up to the margin, or the
// verdict if no distance is asked.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "edgewise/algorithms/near_pair.hpp"
#include "edgewise/algorithms/observer.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/bench/near_margins.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// A verdict in the form of an answer: `touching` and 0 for nearer, else `separated` and the margin; the
/// counts are those of the query `asked`. Steps are 0 where the bounds decided. A failed query stays failed.
[[nodiscard]] inline Distance near_answer(bool nearer, double margin, const Distance& asked = {}) {
    Distance answer;
    answer.status = nearer ? Status::touching : Status::separated;
    answer.distance = nearer ? 0 : margin;
    answer.steps = asked.steps;
    answer.cycles = asked.cycles;
    answer.fallbacks = asked.fallbacks;
    answer.refinements = asked.refinements;
    answer.escapes = asked.escapes;
    return answer;
}

/// Asks the tables, where no bounds decide.
template <class Algorithm, class Table, class Pair, class Observer = NoObserver>
[[nodiscard]] Distance ask_tables_near(const Table& a, const Table& b, const Transform<double>& a_from_b,
                                       NearCache<Pair>& cache, bool warm, const NearMargins& margins,
                                       const scene::Query& query, const QueryOptions& options,
                                       Observer&& observer = {}) {
    const double margin = margins.margin(query);
    QueryOptions cold = options;
    cold.cutoff = margin;
    if (!margins.asks_distance()) cold.contact_tolerance = margin;
    const Distance answer =
        warm ? ask_near<Algorithm>(a, b, a_from_b, margins.radii(query), cache, options, observer)
             : Algorithm::query(a, b, a_from_b, cache.pair, cold, observer);
    if (answer.status == Status::failed) return {};
    const bool nearer = answer.distance < margin;
    return nearer && margins.asks_distance() ? answer : near_answer(nearer, margin, answer);
}

/// A pass over queries of a workload, as Runner::RangePass. Tables: gives a query's two tables.
template <class Algorithm, class Table, class Tables>
class NearPass {
  public:
    using Pair = typename Algorithm::template Pair<Table, Table>;
    using Cache = NearCache<Pair>;

    /// `cold`: of each pair of a warm scene, its cache when it knows nothing. All but `tables` must stay.
    NearPass(const scene::Workload& workload, const NearMargins& margins, const QueryOptions& options,
             Tables tables, const std::vector<Pair>& cold)
        : workload_(workload), margins_(margins), options_(options), tables_(std::move(tables)) {
        for (const Pair& pair : cold) cold_.push_back({{}, pair});
        pairs_ = cold_;
    }

    [[gnu::noinline]] double operator()(std::size_t first, std::size_t last, Distance* answers) {
        if (first == 0) pairs_ = cold_;
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            const scene::Query& query = workload_.queries[i];
            if (const auto told = told_by_bounds(query)) {
                const double margin = margins_.margin(query);
                // No whole answer is made without a reader: it would take as long as the bounds.
                sum += *told ? 0 : margin;
                if (answers) answers[i] = near_answer(*told, margin);
                continue;
            }
            const Distance answer = ask(query);
            if (answers) answers[i] = answer;
            sum += answer.distance;
        }
        return sum;
    }

  private:
    [[nodiscard]] std::optional<bool> told_by_bounds(const scene::Query& query) const {
        if (!workload_.warm) return std::nullopt;
        return margins_.told_by(pairs_[query.pair].bounds, query, relative_pose(query.pose_a, query.pose_b));
    }

    /// Computes the pose again: as an argument it would take memory in the loop that rarely asks.
    [[nodiscard]] [[gnu::noinline]] Distance ask(const scene::Query& query) {
        const Transform<double> a_from_b = relative_pose(query.pose_a, query.pose_b);
        const auto [a, b] = tables_(query);
        Cache cold{{}, Pair(*a, *b)};
        Cache& cache = workload_.warm ? pairs_[query.pair] : cold;
        return ask_tables_near<Algorithm>(*a, *b, a_from_b, cache, workload_.warm, margins_, query, options_);
    }

    const scene::Workload& workload_;
    const NearMargins& margins_;
    const QueryOptions& options_;
    Tables tables_;
    std::vector<Cache> cold_, pairs_;
};

}  // namespace edgewise::bench
