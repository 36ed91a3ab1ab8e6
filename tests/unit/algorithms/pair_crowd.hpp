// SPDX-License-Identifier: MIT
//
// Many pairs to be asked by themselves and in a batch, for tests that hold one against the other.
#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

#include "edgewise/algorithms/query_batch.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise {

/// Bodies of 4 to 386 vertices, in pairs of any two, far, near and overlapping; each pair twice, to be asked
/// by itself and in a batch.
template <class Table, class Algorithm = Gjk>
struct PairCrowd {
    using Pairs = std::vector<typename Algorithm::template Pair<Table, Table>>;
    std::vector<Table> tables;
    Pairs single_pairs, batch_pairs;
    std::vector<PairQuery<Table, Table, Algorithm>> queries;

    explicit PairCrowd(std::size_t count) {
        for (const char* shape : {"tetra4", "cube8", "sphere8", "sphere18", "sphere38", "sphere386"})
            tables.emplace_back(scene::make_shape(shape).or_throw(), Algorithm::parts);
        scene::Rng rng(7);
        for (std::size_t i = 0; i < count; ++i) {
            const Table &a = tables[i % 5 + (i % 31 == 0)], &b = tables[i * 7 / 3 % 5];
            const Vec3d offset = rng.on_sphere() * rng.uniform(0.5, 5);
            batch_pairs.emplace_back(a, b);
            queries.push_back({&a, &b, {rng.rotation(), offset}, nullptr});
        }
        single_pairs = batch_pairs;
        for (std::size_t i = 0; i < count; ++i) queries[i].pair = &batch_pairs[i];
    }
    /// Another frame: every pair moved by up to this much.
    void move(double step) {
        scene::Rng rng(3);
        for (auto& query : queries) query.a_from_b.translation += rng.in_ball() * step;
    }
    std::vector<Distance> one_by_one(const QueryOptions& options) {
        std::vector<Distance> answers;
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const auto& query = queries[i];
            answers.push_back(Algorithm::query(*query.a, *query.b, query.a_from_b, single_pairs[i], options));
        }
        return answers;
    }
};

inline bool same_bits(const Distance& a, const Distance& b) {
    const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
    return a.status == b.status && a.steps == b.steps && a.cycles == b.cycles && a.fallbacks == b.fallbacks &&
           a.refinements == b.refinements && a.escapes == b.escapes && same(a.distance, b.distance) &&
           same(a.point_a, b.point_a) && same(a.point_b, b.point_b) && same(a.normal, b.normal);
}

}  // namespace edgewise
