// SPDX-License-Identifier: MIT
//
// Support queries by themselves, as GJK makes them and without it: the farthest vertex along directions that
// are drawn once, asked of a cell's tables in turn. What a layout gives to climbs alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "edgewise/algorithms/support.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/table/contract.hpp"

namespace edgewise::bench {

/// Mean time of a support query in each repetition, in ns.
struct SupportTimes {
    std::vector<double> cold_ns;  ///< in a direction of its own, from the first vertex or the table's seed
    std::vector<double> warm_ns;  ///< a twentieth of a radian on, from the last one of this table
    double heights = 0;           ///< sum of all heights; reading it keeps the queries in the compiled code
};

/// Number of queries in a repetition; with many tables, four for each.
inline constexpr std::size_t least_supports = 1000, supports_of_table = 4;

/// Unit vectors: each its own, or (`turn` > 0, rad) each so far from the one before.
template <class Scalar>
[[nodiscard]] std::vector<Vec3<Scalar>> support_directions(std::size_t count, double turn) {
    scene::Rng rng(2509);
    std::vector<Vec3<Scalar>> directions;
    Vec3d at = rng.on_sphere();
    for (std::size_t i = 0; i < count; ++i) {
        directions.push_back(edgewise::cast<Scalar>(at));
        if (turn > 0) {
            const Vec3d aside = cross(at, rng.on_sphere());
            at += turn / norm(aside) * aside;
            at /= norm(at);
        } else {
            at = rng.on_sphere();
        }
    }
    return directions;
}

/// Runs one pass; returns the sum of heights. Query i is of table i modulo their number, and queries of a
/// table follow the directions in order. last: empty for cold starts, or each table's next start.
template <class Table>
[[nodiscard]] EDGEWISE_QUERY_LOOP double ask_supports(const std::vector<Table>& tables,
                                                      const std::vector<Vec3<ComputeOf<Table>>>& directions,
                                                      std::vector<typename Table::Vertex>& last) {
    double sum = 0;
    for (const auto& direction : directions) {
        for (std::size_t t = 0; t < tables.size(); ++t) {
            const auto found = last.empty() ? cold_support(tables[t], direction, tables[t].first_vertex())
                                            : support(tables[t], direction, last[t]);
            if (!last.empty()) last[t] = found.vertex;
            sum += static_cast<double>(found.along);
        }
    }
    return sum;
}

/// Returns the times of support queries. Empty if the algorithm reads more than support points.
template <class Algorithm, class Table>
[[nodiscard]] SupportTimes time_supports(const std::vector<Table>& tables, int repetitions) {
    using Scalar = ComputeOf<Table>;
    SupportTimes times;
    if (Algorithm::parts != Parts::support || tables.empty()) return times;
    const std::size_t each = std::max(supports_of_table, least_supports / tables.size());
    const auto cold = support_directions<Scalar>(each, 0);
    auto warm = support_directions<Scalar>(each + 1, 0.05);
    const std::vector<Vec3<Scalar>> start = {warm.front()};  // each table's first is a cold one
    warm.erase(warm.begin());
    const auto queries = static_cast<double>(each * tables.size());
    for (int i = 0; i < repetitions; ++i) {
        std::vector<typename Table::Vertex> none, last;
        for (const Table& table : tables) last.push_back(table.first_vertex());
        const measure::Stopwatch cold_watch;
        times.heights += ask_supports(tables, cold, none);
        times.cold_ns.push_back(cold_watch.elapsed_ns() / queries);
        times.heights += ask_supports(tables, start, last);
        const measure::Stopwatch warm_watch;
        times.heights += ask_supports(tables, warm, last);
        times.warm_ns.push_back(warm_watch.elapsed_ns() / queries);
    }
    return times;
}

}  // namespace edgewise::bench
