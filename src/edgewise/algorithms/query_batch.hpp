// SPDX-License-Identifier: MIT
//
// Many pairs at once: queries in, answers out, each to the bit that of a single query. GJK's cold pairs of
// small bodies, for which a scan finds support points, are answered several at a time, one per lane of the
// processor's registers (lanes/lane_gjk.hpp). Other pairs, of V-Clip too, and pairs that Johnson's search
// solves, go one after the other, while the memory of later queries is being fetched.
#pragma once

#include <algorithm>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "edgewise/algorithms/answerable.hpp"
#include "edgewise/algorithms/distance.hpp"
#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/lanes/lane_source.hpp"
#include "edgewise/algorithms/lanes/lane_width.hpp"
#include "edgewise/algorithms/query_options.hpp"
#include "edgewise/algorithms/subset.hpp"
#include "edgewise/algorithms/support.hpp"
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

/// A table with handles that count the vertices from 0: a lane can name them.
template <class Table>
concept LaneTable = SupportTable<Table> && std::unsigned_integral<typename Table::Vertex> && requires {
    requires Table::counts_vertices;
};

/// Returns true if a scan finds this table's support points: then lanes can find them.
template <LaneTable Table>
[[nodiscard]] bool fits_lane(const Table& table) {
    if constexpr (ClimbingTable<Table>) {
        static_assert(
            scan_below<Table> == most_lane_vertices + 1 && scan_cold_below<Table> == most_lane_vertices + 1,
            "a single query must find the vertices that lanes find");
    }
    return table.vertex_count() <= most_lane_vertices;
}

/// Runs query_batch where lanes can do it.
template <LaneTable TableA, LaneTable TableB>
class GjkBatch final : public LaneSource<ComputeOf<TableA>> {
  public:
    using Scalar = ComputeOf<TableA>;
    using Query = PairQuery<TableA, TableB>;

    GjkBatch(std::span<const Query> queries, std::span<Distance> answers, const QueryOptions& options)
        : queries_(queries), answers_(answers), options_(options) {
        assert(queries.size() == answers.size());
        assert(options.sub_distance == SubDistanceSolver::cofactors && "lanes know no other");
    }

    /// `width`: a width other than none.
    void run(LaneWidth width) { run_lanes(*this, options_, width); }

    [[nodiscard]] bool next(int lane, LaneQuery<Scalar>& query) override {
        for (; next_ < queries_.size(); ++next_) {
            fetch_ahead(queries_, next_);
            if (!start(queries_[next_], query)) {
                ask(next_);
                continue;
            }
            in_lane_[lane] = {next_, query.a_from_b};
            ++next_;
            return true;
        }
        return false;
    }

    void write_a(int lane, LaneVertices<Scalar> vertices) override {
        write(*queries_[in_lane_[lane].number].a, vertices);
    }
    void write_b(int lane, LaneVertices<Scalar> vertices) override {
        write(*queries_[in_lane_[lane].number].b, vertices);
    }

    void take(int lane, const LaneAnswer<Scalar>& answer) override {
        const auto& [number, a_from_b] = in_lane_[lane];
        const Query& query = queries_[number];
        EndSimplex simplex;
        simplex.count = answer.count;
        for (int i = 0; i < answer.count; ++i) {
            simplex.a[i] = static_cast<typename TableA::Vertex>(answer.vertex_a[i]);
            simplex.b[i] = static_cast<typename TableB::Vertex>(answer.vertex_b[i]);
            simplex.points_a[i] = query.a->vertex(simplex.a[i]);
            simplex.points_b[i] = a_from_b.point(query.b->vertex(simplex.b[i]));
        }
        ClosestOfSimplex<Scalar> closest;
        closest.weight = answer.weight;
        closest.point = answer.closest;
        if (!reaches_closest(simplex, closest, simplex.size())) return ask(number);
        const Distance found = gjk_answer(simplex, closest, Status::separated, answer.steps);
        query.pair->hold(*query.a, *query.b, simplex, found.distance);
        answers_[number] = within(options_, found);
    }

    void ask_singly(int lane) override { ask(in_lane_[lane].number); }

    /// Queries that lanes did not answer.
    [[nodiscard]] std::size_t asked_singly() const { return asked_singly_; }

  private:
    static constexpr std::size_t most_lanes = 8;  ///< 256 bits of float

    /// The simplex at the end of a query, as its answer and its pair read it.
    struct EndSimplex {
        int count = 0;
        SmallArray<typename TableA::Vertex, 4> a{};
        SmallArray<typename TableB::Vertex, 4> b{};
        SmallArray<Vec3<Scalar>, 4> points_a, points_b;

        [[nodiscard]] auto vertex_a(int i) const { return a[i]; }
        [[nodiscard]] auto vertex_b(int i) const { return b[i]; }
        [[nodiscard]] const Vec3<Scalar>& on_a(int i) const { return points_a[i]; }
        [[nodiscard]] const Vec3<Scalar>& on_b(int i) const { return points_b[i]; }
        /// Longest coordinate; a single query's, of all points that it met, is no smaller.
        [[nodiscard]] Scalar size() const {
            Scalar longest = 0;
            for (int i = 0; i < count; ++i) longest = std::max({longest, max_abs(on_a(i)), max_abs(on_b(i))});
            return longest;
        }
    };

    struct InLane {
        std::size_t number = 0;
        Transform<Scalar> a_from_b;
    };

    template <class Table>
    static void write(const Table& table, LaneVertices<Scalar> vertices) {
        for (const auto v : table.all_vertices()) vertices.push(table.vertex(v));
    }

    void ask(std::size_t number) {
        ++asked_singly_;
        answers_[number] = ask_one(queries_[number], options_);
    }

    /// False: not for lanes. Warm queries are not: for pairs that moved by 0.01 to 1 rad lanes took 1.1 to
    /// 1.7 times as long as single queries, since most warm queries end after one support point.
    [[nodiscard]] bool start(const Query& given, LaneQuery<Scalar>& query) const {
        if (!is_answerable(*given.a, *given.b, given.a_from_b)) [[unlikely]]
            return false;  // the single query says so
        if (given.pair->starts_warm(*given.a, *given.b)) return false;
        if (!fits_lane(*given.a) || !fits_lane(*given.b)) return false;
        query.a_from_b = cast<Scalar>(given.a_from_b);
        query.table_a = given.a;
        query.table_b = given.b;
        query.vertices_a = static_cast<int>(given.a->vertex_count());
        query.vertices_b = static_cast<int>(given.b->vertex_count());
        return true;
    }

    std::span<const Query> queries_;
    std::span<Distance> answers_;
    QueryOptions options_;
    std::size_t next_ = 0, asked_singly_ = 0;
    SmallArray<InLane, most_lanes> in_lane_;
};

/// Answers queries[i] in answers[i]. Disjoint parts of a batch may run in threads of their own: they share
/// only tables, which are read (parallel_batch.hpp). V-Clip has no lanes, and ignores the width.
template <SupportTable TableA, SupportTable TableB, class Algorithm = Gjk>
void query_batch(PairQueries<TableA, TableB, Algorithm> queries, std::span<Distance> answers,
                 const QueryOptions& options = {}, LaneWidth width = best_lanes()) {
    assert(queries.size() == answers.size());
    if constexpr (std::is_same_v<Algorithm, Gjk> && LaneTable<TableA> && LaneTable<TableB>) {
        const bool by_cofactors = options.sub_distance == SubDistanceSolver::cofactors;
        if (by_cofactors && width != LaneWidth::none)
            return GjkBatch<TableA, TableB>(queries, answers, options).run(width);
    }
    ask_in_order(queries, answers, options);
}

}  // namespace edgewise
