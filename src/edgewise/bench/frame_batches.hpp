// SPDX-License-Identifier: MIT
//
// A workload's queries as batches: frame k holds the k-th query of every pair, whatever the order in which
// the scene asks them, since pairs know nothing of each other. Of a scene without warm pairs all queries are
// one frame. Relative poses are made ready before: a pass is queries and the handing out of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "edgewise/algorithms/parallel_batch.hpp"
#include "edgewise/bench/runner.hpp"
#include "edgewise/scene/workload.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise::bench {

/// Positions of queries in the workload, by frame.
[[nodiscard]] inline std::vector<std::vector<std::size_t>> frames_of(const scene::Workload& workload) {
    std::vector<std::vector<std::size_t>> frames;
    std::vector<std::size_t> asked(workload.warm ? workload.pair_count : 0, 0);
    for (std::size_t i = 0; i < workload.queries.size(); ++i) {
        const std::size_t frame = workload.warm ? asked[workload.queries[i].pair]++ : 0;
        if (frame == frames.size()) frames.emplace_back();
        frames[frame].push_back(i);
    }
    return frames;
}

template <class Algorithm, class Table>
class FrameBatches final : public ThreadedPass {
  public:
    using Pair = typename Algorithm::template Pair<Table, Table>;

    /// tables: gives a query's two tables, which must stay; the workload need not.
    template <class Tables>
    FrameBatches(const scene::Workload& workload, const QueryOptions& options, const Tables& tables)
        : options_(options), answers_(workload.queries.size()) {
        for (const auto& frame : frames_of(workload)) {
            for (const std::size_t i : frame) add(workload, i, tables(workload.queries[i]));
            ends_.push_back(queries_.size());
        }
        pairs_ = cold_;
        for (std::size_t i = 0; i < queries_.size(); ++i) queries_[i].pair = &pairs_[slots_[i]];
    }

    void set_back() override { std::copy(cold_.begin(), cold_.end(), pairs_.begin()); }

    void run(int threads) override {
        tbb::task_arena arena(threads);
        std::size_t first = 0;
        for (const std::size_t end : ends_) {
            query_batch_parallel<Table, Table, Algorithm>(std::span(queries_).subspan(first, end - first),
                                                          std::span(answers_).subspan(first, end - first),
                                                          options_, arena);
            first = end;
        }
    }

    [[nodiscard]] double sum() const override {
        std::vector<double> distances(answers_.size());
        for (std::size_t i = 0; i < answers_.size(); ++i) distances[numbers_[i]] = answers_[i].distance;
        double sum = 0;
        for (const double distance : distances) sum += distance;
        return sum;
    }

    [[nodiscard]] std::size_t frames() const override { return ends_.size(); }

  private:
    /// A pair's first query makes its cache: caches lie in the order in which the first frame asks them.
    void add(const scene::Workload& workload, std::size_t number,
             const std::pair<const Table*, const Table*>& tables) {
        const scene::Query& query = workload.queries[number];
        const auto [a, b] = tables;
        const std::size_t pair = workload.warm ? query.pair : number;
        if (slot_of_.size() <= pair) slot_of_.resize(pair + 1, no_slot);
        if (slot_of_[pair] == no_slot) {
            slot_of_[pair] = cold_.size();
            cold_.emplace_back(*a, *b);
        }
        slots_.push_back(slot_of_[pair]);
        numbers_.push_back(number);
        queries_.push_back({a, b, relative_pose(query.pose_a, query.pose_b), nullptr});
    }

    static constexpr std::size_t no_slot = SIZE_MAX;

    QueryOptions options_;
    std::vector<std::size_t> slot_of_;  ///< by the workload's pairs
    std::vector<std::size_t> slots_,
        numbers_;                    ///< by query here: its pair's cache, its number in the workload
    std::vector<std::size_t> ends_;  ///< of frames, in queries_
    std::vector<PairQuery<Table, Table, Algorithm>> queries_;
    std::vector<Pair> cold_, pairs_;
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
