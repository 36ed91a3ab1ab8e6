// SPDX-License-Identifier: MIT
//
// One query as a value, so that a caller can hand over many at once, and the simplest way to answer many: one
// after the other, while the memory of later queries is being fetched.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>

#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/query_options.hpp"

namespace edgewise {

/// One query: the arguments of Algorithm::query (Gjk, or VClip). No two of a batch may share a pair.
template <SupportTable TableA, SupportTable TableB, class Algorithm = Gjk>
struct PairQuery {
    const TableA* a;
    const TableB* b;
    Transform<double> a_from_b;
    typename Algorithm::template Pair<TableA, TableB>* pair;
};

/// A batch as a parameter: any contiguous range converts, so its types are named, not deduced.
template <SupportTable TableA, SupportTable TableB, class Algorithm>
using PairQueries = std::type_identity_t<std::span<const PairQuery<TableA, TableB, Algorithm>>>;

/// Prefetches the memory of a later query.
template <class Query>
void fetch_ahead(std::span<const Query> queries, std::size_t of) {
    constexpr std::size_t ahead = 8;
    if (of + ahead >= queries.size()) return;
    const Query& query = queries[of + ahead];
    __builtin_prefetch(query.a);
    __builtin_prefetch(query.b);
    __builtin_prefetch(query.pair);
}

template <class TableA, class TableB, class Algorithm>
[[nodiscard]] Distance ask_one(const PairQuery<TableA, TableB, Algorithm>& query,
                               const QueryOptions& options) {
    return Algorithm::query(*query.a, *query.b, query.a_from_b, *query.pair, options);
}

/// Answers queries[i] in answers[i], one after the other.
template <class Query>
void ask_in_order(std::span<const Query> queries, std::span<Distance> answers, const QueryOptions& options) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
        fetch_ahead(queries, i);
        answers[i] = ask_one(queries[i], options);
    }
}

}  // namespace edgewise
