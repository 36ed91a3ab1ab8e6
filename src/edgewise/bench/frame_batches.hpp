// SPDX-License-Identifier: MIT
//
// A workload's queries as batches: frame k holds the k-th query of every pair, whatever the order in which
// the scene asks them, since pairs know nothing of each other. Of a scene without warm pairs all queries are
// one frame. Relative poses are made ready before: a pass is queries and the handing out of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "edgewise/algorithms/parallel_batch.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise::bench {

/// The order in which batches ask a workload's queries.
struct FrameOrder {
    std::vector<std::size_t> numbers;  ///< in the workload, frame by frame
    std::vector<std::size_t> ends;     ///< of frames, in numbers
    std::vector<std::size_t> caches;   ///< the number of each query's pair, in the order of the first frame

    explicit FrameOrder(const scene::Workload& workload)
        : numbers(workload.queries.size()), caches(numbers.size()) {
        const auto pair_of = [&](std::size_t number) {
            return workload.warm ? workload.queries[number].pair : number;
        };
        std::vector<std::size_t> frame(numbers.size()),
            asked(workload.warm ? workload.pair_count : frame.size()), cache_of(asked.size());
        for (std::size_t i = 0; i < frame.size(); ++i) frame[i] = asked[pair_of(i)]++;
        std::iota(numbers.begin(), numbers.end(), 0);
        std::ranges::stable_sort(numbers, {}, [&](std::size_t i) { return frame[i]; });
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            // Every pair is in the first frame: there a query's place is that of its pair's cache.
            if (frame[numbers[i]] == 0) cache_of[pair_of(numbers[i])] = i;
            caches[i] = cache_of[pair_of(numbers[i])];
            if (i + 1 == numbers.size() || frame[numbers[i + 1]] != frame[numbers[i]]) ends.push_back(i + 1);
        }
    }
};

template <class Algorithm, class Table>
class FrameBatches final : public ThreadedPass {
  public:
    /// tables: gives a query's two tables, which must stay; the workload need not.
    template <class Tables>
    FrameBatches(const scene::Workload& workload, const QueryOptions& options, const Tables& tables)
        : options_(options), order_(workload), answers_(workload.queries.size()) {
        for (const std::size_t number : order_.numbers) {
            const scene::Query& query = workload.queries[number];
            const auto [a, b] = tables(query);
            queries_.push_back({a, b, relative_pose(query.pose_a, query.pose_b), nullptr});
        }
        if (queries_.empty()) return;
        for (std::size_t i = 0; i < order_.ends.front(); ++i)
            cold_.emplace_back(*queries_[i].a, *queries_[i].b);
        pairs_ = cold_;
        for (std::size_t i = 0; i < queries_.size(); ++i) queries_[i].pair = &pairs_[order_.caches[i]];
    }

    void set_back() override { std::copy(cold_.begin(), cold_.end(), pairs_.begin()); }

    void run(int threads) override {
        tbb::task_arena arena(threads);
        std::size_t first = 0;
        for (const std::size_t end : order_.ends) {
            query_batch_parallel<Table, Table, Algorithm>(std::span(queries_).subspan(first, end - first),
                                                          std::span(answers_).subspan(first, end - first),
                                                          options_, arena);
            first = end;
        }
    }

    [[nodiscard]] double sum() const override {
        std::vector<double> distances(answers_.size());
        for (std::size_t i = 0; i < answers_.size(); ++i) distances[order_.numbers[i]] = answers_[i].distance;
        return std::accumulate(distances.begin(), distances.end(), 0.0);
    }

    [[nodiscard]] std::size_t frames() const override { return order_.ends.size(); }

  private:
    QueryOptions options_;
    FrameOrder order_;
    std::vector<PairQuery<Table, Table, Algorithm>> queries_;
    std::vector<typename Algorithm::template Pair<Table, Table>> cold_, pairs_;
    std::vector<Distance> answers_;
};

/// Null for tables that queries write to, which serve one thread at a time.
template <class Algorithm, class Table, class Tables>
[[nodiscard]] std::unique_ptr<ThreadedPass> frame_batches(const scene::Workload& workload,
                                                          const QueryOptions& options, const Tables& tables) {
    if constexpr (queries_write<Table>)
        return nullptr;
    else
        return std::make_unique<FrameBatches<Algorithm, Table>>(workload, options, tables);
}

}  // namespace edgewise::bench
