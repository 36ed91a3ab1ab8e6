// SPDX-License-Identifier: MIT
//
// Many pairs at once: queries in, answers out, each to the bit that of a single query. GJK searches for the
// closest points of cold pairs of small bodies several at a time, one per lane of the processor's registers
// (search/lane_search.hpp). Other pairs, of V-Clip too, and pairs that Johnson's search solves, go one after
// the other, while the memory of later queries is being fetched.
#pragma once

#include <cassert>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/search/single_search.hpp"
#include "edgewise/table/small_array.hpp"

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

/// Runs query_batch where lanes can do it.
template <NumberedTable TableA, NumberedTable TableB>
class GjkBatch final : public SearchSource {
  public:
    using Query = PairQuery<TableA, TableB>;

    GjkBatch(std::span<const Query> queries, std::span<Distance> answers, const QueryOptions& options)
        : queries_(queries), answers_(answers), options_(options) {
        assert(queries.size() == answers.size());
        assert(fit_lanes(options));
    }

    /// Lanes know no other solver, and no cutoff: single queries first look along the line of the origins.
    [[nodiscard]] static bool fit_lanes(const QueryOptions& options) {
        return options.sub_distance == SubDistanceSolver::cofactors && std::isinf(options.cutoff);
    }

    /// Answers all queries, on a processor that has_lanes().
    void run() { run_lane_searches(*this); }

    [[nodiscard]] bool next(int lane, SingleSearch& search) override {
        for (; next_ < queries_.size(); ++next_) {
            fetch_ahead(queries_, next_);
            const Query& query = queries_[next_];
            if (!fits_lane(query)) {
                ++asked_singly_;
                answers_[next_] = ask_one(query, options_);
                continue;
            }
            write_search(*query.a, *query.b, in_scalar<Scalar>(query.a_from_b),
                         static_cast<Scalar>(options_.cutoff), search);
            in_lane_[lane] = next_++;
            return true;
        }
        return false;
    }

    void take(int lane, const SingleSearchEnd& end) override {
        const Query& query = queries_[in_lane_[lane]];
        Distance& answer = answers_[in_lane_[lane]];
        const auto& a_from_b = in_scalar<Scalar>(query.a_from_b);
        run_gjk_from(end, *query.a, *query.b, a_from_b, *query.pair, options_, answer);
        apply_tolerance(options_, answer);
    }

    /// Queries that lanes did not search for.
    [[nodiscard]] std::size_t asked_singly() const { return asked_singly_; }

  private:
    using Scalar = ComputeOf<TableA>;
    static constexpr std::size_t most_lanes = 8;  ///< 256 bits of float

    /// Warm queries do not: most of them end where they start, without a search.
    [[nodiscard]] static bool fits_lane(const Query& query) {
        return query.a->vertex_count() <= SingleVertices::most &&
               query.b->vertex_count() <= SingleVertices::most &&
               !query.pair->starts_warm(*query.a, *query.b) &&
               is_answerable(*query.a, *query.b, query.a_from_b);  // else the single query says so
    }

    std::span<const Query> queries_;
    std::span<Distance> answers_;
    QueryOptions options_;
    std::size_t next_ = 0, asked_singly_ = 0;
    SmallArray<std::size_t, most_lanes> in_lane_{};  ///< number of the query
};

/// Answers queries[i] in answers[i]. Disjoint parts of a batch may run in threads of their own: they share
/// only tables, which are read (parallel_batch.hpp). V-Clip has no lanes.
template <SupportTable TableA, SupportTable TableB, class Algorithm = Gjk>
void query_batch(PairQueries<TableA, TableB, Algorithm> queries, std::span<Distance> answers,
                 const QueryOptions& options = {}, bool in_lanes = has_lanes()) {
    assert(queries.size() == answers.size());
    if constexpr (std::is_same_v<Algorithm, Gjk> && NumberedTable<TableA> && NumberedTable<TableB>) {
        using Batch = GjkBatch<TableA, TableB>;
        if (in_lanes && Batch::fit_lanes(options)) return Batch(queries, answers, options).run();
    }
    ask_in_order(queries, answers, options);
}

}  // namespace edgewise
