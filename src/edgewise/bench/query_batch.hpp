// SPDX-License-Identifier: MIT
//
// A workload's queries collected for GJK's batch: as many as stay in the first-level cache with their
// answers.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "edgewise/algorithms/gjk_batch.hpp"
#include "edgewise/scene/workload.hpp"

namespace edgewise::bench {

template <class Table>
class QueryBatch {
  public:
    using Pair = SimplexPair<Table, Table>;

    explicit QueryBatch(const QueryOptions& options) : options_(options) {}

    [[nodiscard]] bool is_full() const { return count_ == most; }
    /// Whether this pair is asked already.
    [[nodiscard]] bool holds(const Pair& pair) const {
        const auto end = queries_.begin() + static_cast<std::ptrdiff_t>(count_);
        return std::any_of(queries_.begin(), end, [&](const auto& query) { return query.pair == &pair; });
    }

    /// Query `number`; pair: none starts cold.
    void add(std::size_t number, const Table& a, const Table& b, const Transform<double>& a_from_b,
             Pair* pair) {
        assert(!is_full());
        if (!pair) {
            cold_[count_] = Pair(a, b);
            pair = &cold_[count_];
        }
        numbers_[count_] = number;
        queries_[count_++] = {&a, &b, a_from_b, pair};
    }

    /// Asks all, tells take(number, pair, answer) of each, and is empty.
    template <class Take>
    void ask(const Take& take) {
        query_batch<Table, Table>(std::span(queries_).first(count_), std::span(answers_).first(count_),
                                  options_);
        for (std::size_t i = 0; i < count_; ++i) take(numbers_[i], *queries_[i].pair, answers_[i]);
        count_ = 0;
    }

  private:
    static constexpr std::size_t most = 64;

    QueryOptions options_;
    std::array<PairQuery<Table, Table>, most> queries_;
    std::array<Pair, most> cold_;
    std::array<Distance, most> answers_;
    std::array<std::size_t, most> numbers_{};
    std::size_t count_ = 0;
};

/// A pass over queries of a workload, as Runner::RangePass, that asks them in batches. A batch ends where a
/// pair of it comes again, since its next query starts from this one's. Tables: gives a query's two tables;
/// Pay: is called with every query, its pair and its answer.
template <class Table, class Tables, class Pay>
class BatchPass {
  public:
    using Pair = SimplexPair<Table, Table>;

    /// `cold`: of each pair of a warm scene, its cache when it knows nothing. The workload must stay.
    BatchPass(const scene::Workload& workload, const QueryOptions& options, Tables tables, Pay pay,
              const std::vector<Pair>& cold)
        : workload_(workload),
          tables_(std::move(tables)),
          pay_(std::move(pay)),
          cold_(cold),
          pairs_(cold),
          batch_(options) {}

    double operator()(std::size_t first, std::size_t last, Distance* answers) {
        if (first == 0) std::copy(cold_.begin(), cold_.end(), pairs_.begin());
        double sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            const scene::Query& query = workload_.queries[i];
            Pair* pair = workload_.warm ? &pairs_[query.pair] : nullptr;
            if (batch_.is_full() || (pair && batch_.holds(*pair))) ask(answers, sum);
            const auto [a, b] = tables_(query);
            batch_.add(i, *a, *b, relative_pose(query.pose_a, query.pose_b), pair);
        }
        ask(answers, sum);
        return sum;
    }

  private:
    /// Adds distances one by one, in the order of queries: a sum has the bits of a pass that asks singly.
    void ask(Distance* answers, double& sum) {
        batch_.ask([&](std::size_t i, const Pair& pair, const Distance& answer) {
            pay_(workload_.queries[i], pair, answer);
            if (answers) answers[i] = answer;
            sum += answer.distance;
        });
    }

    const scene::Workload& workload_;
    Tables tables_;
    Pay pay_;
    std::vector<Pair> cold_, pairs_;
    QueryBatch<Table> batch_;
};

}  // namespace edgewise::bench
