// SPDX-License-Identifier: MIT
//
// An engine's frame: many pairs of bodies asked at once, in two threads. Only parallel_batch.hpp
// needs TBB; a program that includes it links TBB itself.
#include <cstdio>
#include <edgewise/algorithms/parallel_batch.hpp>
#include <edgewise/algorithms/vclip.hpp>
#include <edgewise/geometry/hull.hpp>
#include <edgewise/layouts/lean.hpp>
#include <vector>

using Table = edgewise::lean<edgewise::f64>;

template <class Algorithm>
double sum_of_distances(const Table& table, int bodies) {
    std::vector<edgewise::Distance> answers(static_cast<std::size_t>(bodies));
    std::vector<typename Algorithm::template Pair<Table, Table>> pairs(answers.size(), {table, table});
    std::vector<edgewise::PairQuery<Table, Table, Algorithm>> queries(answers.size());
    edgewise::Pose a, b;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        b.translation = {2 + static_cast<double>(i), 0, 0};
        queries[i] = {&table, &table, edgewise::relative_pose(a, b), &pairs[i]};
    }
    edgewise::query_batch_parallel<Table, Table, Algorithm>(queries, answers, {}, 2);
    double sum = 0;
    for (const edgewise::Distance& answer : answers) sum += answer.distance;
    return sum;
}

int main() {
    const std::vector<edgewise::Vec3d> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const Table table(*edgewise::convex_hull(points), edgewise::Parts::features);
    std::printf("%g %g\n", sum_of_distances<edgewise::Gjk>(table, 1000),
                sum_of_distances<edgewise::VClip>(table, 1000));
}
