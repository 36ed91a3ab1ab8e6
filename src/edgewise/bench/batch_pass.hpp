// SPDX-License-Identifier: MIT
//
// A pass over queries of a workload, as Runner::RangePass, that asks them in batches. A batch ends where a
// pair of it comes again, since its next query starts from this one's.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "edgewise/algorithms/query_batch.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

/// Queries of a batch, at most 64: they stay in the first-level cache with their answers.
template <class Algorithm, class Table>
class QueryBatch {
  public:
    using Pair = typename Algorithm::template Pair<Table, Table>;

    explicit QueryBatch(const QueryOptions& options) : options_(options) {}

    [[nodiscard]] bool is_full() const { return count_ == most; }

    /// Query `number`; pair: none starts cold.
    void add(std::size_t number, const Table& a, const Table& b, const Transform<double>& a_from_b,
             Pair* pair) {
        assert(!is_full());
        if (!pair) pair = &cold_[count_].emplace(a, b);
        numbers_[count_] = number;
        queries_[count_++] = {&a, &b, a_from_b, pair};
    }

    /// Answers all, calls take(number, pair, answer) for each, and is then empty.
    template <class Take>
    void ask(const Take& take) {
        query_batch<Table, Table, Algorithm>(std::span(queries_).first(count_),
                                             std::span(answers_).first(count_), options_);
        for (std::size_t i = 0; i < count_; ++i) take(numbers_[i], *queries_[i].pair, answers_[i]);
        count_ = 0;
    }

  private:
    static constexpr std::size_t most = 64;

    QueryOptions options_;
    std::array<PairQuery<Table, Table, Algorithm>, most> queries_;
    std::array<std::optional<Pair>, most> cold_;
    std::array<Distance, most> answers_;
    std::array<std::size_t, most> numbers_{};
    std::size_t count_ = 0;
};

/// Tables: gives a query's two tables; Pay: is called with every query, its pair and its answer.
template <class Algorithm, class Table, class Tables, class Pay>
class BatchPass {
  public:
    using Pair = typename Algorithm::template Pair<Table, Table>;

    /// `cold`: of each pair of a warm scene, its cache when it knows nothing. The workload must stay.
    BatchPass(const scene::Workload& workload, const QueryOptions& options, Tables tables, Pay pay,
              const std::vector<Pair>& cold)
        : workload_(workload),
          tables_(std::move(tables)),
          pay_(std::move(pay)),
          cold_(cold),
          pairs_(cold),
          asked_in_(cold.size(), 0),
          batch_(options) {}

    double operator()(std::size_t first, std::size_t last, Distance* answers) {
        if (first == 0) std::copy(cold_.begin(), cold_.end(), pairs_.begin());
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            const scene::Query& query = workload_.queries[i];
            if (batch_.is_full() || (workload_.warm && asked_in_[query.pair] == batch_number_))
                ask(answers, sum);
            const auto [a, b] = tables_(query);
            batch_.add(i, *a, *b, relative_pose(query.pose_a, query.pose_b), pair_of(query));
        }
        ask(answers, sum);
        return sum;
    }

  private:
    /// The pair's cache, which is in this batch from now on; none in a cold scene.
    [[nodiscard]] Pair* pair_of(const scene::Query& query) {
        if (!workload_.warm) return nullptr;
        asked_in_[query.pair] = batch_number_;
        return &pairs_[query.pair];
    }

    /// Adds distances one by one, in the order of queries: a sum has the bits of a pass that asks singly.
    void ask(Distance* answers, double& sum) {
        batch_.ask([&](std::size_t i, const Pair& pair, const Distance& answer) {
            pay_(workload_.queries[i], pair, answer);
            if (answers) answers[i] = answer;
            sum += answer.distance;
        });
        ++batch_number_;
    }

    const scene::Workload& workload_;
    Tables tables_;
    Pay pay_;
    std::vector<Pair> cold_, pairs_;
    std::vector<std::uint64_t> asked_in_;  ///< by pair: the last batch that it was in
    std::uint64_t batch_number_ = 1;
    QueryBatch<Algorithm, Table> batch_;
};

}  // namespace edgewise::bench
