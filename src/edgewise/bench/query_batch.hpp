// SPDX-License-Identifier: MIT
//
// A workload's queries collected for a batch, up to the number that stays in the first-level cache with their
// answers.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>

#include "edgewise/algorithms/query_batch.hpp"

namespace edgewise::bench {

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
        if (!pair) {
            pair = &cold_[count_].emplace(a, b);
        }
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

}  // namespace edgewise::bench
