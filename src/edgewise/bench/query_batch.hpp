// SPDX-License-Identifier: MIT
//
// A workload's queries collected for GJK's batch: as many as stay in the first-level cache with their
// answers.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <span>

#include "edgewise/algorithms/gjk_batch.hpp"

namespace edgewise::bench {

template <class Table>
class QueryBatch {
  public:
    using Pair = SimplexPair<Table, Table>;

    explicit QueryBatch(const QueryOptions& options) : options_(options) {}

    [[nodiscard]] bool is_full() const { return count_ == most; }

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

}  // namespace edgewise::bench
