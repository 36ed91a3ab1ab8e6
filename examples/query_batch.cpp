// SPDX-License-Identifier: MIT
//
// Many pairs asked at once: GJK computes several of them in the lanes of vector registers, with the answers
// of single queries to the bit. For threads see many_pairs.cpp.
#include <cstdio>
#include <edgewise/algorithms/query_batch.hpp>
#include <edgewise/geometry/hull.hpp>
#include <edgewise/layouts/points_soa.hpp>
#include <vector>

int main() {
    using Table = edgewise::points_soa<edgewise::f32>;
    using Query = edgewise::PairQuery<Table, Table>;

    const std::vector<edgewise::Vec3d> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const auto body = edgewise::convex_hull(points);
    if (!body) {
        std::fprintf(stderr, "%s\n", body.error.c_str());
        return 1;
    }
    const Table table(*body, edgewise::Parts::support);

    std::vector<edgewise::Distance> answers(1000);
    std::vector<edgewise::SimplexPair<Table, Table>> pairs(answers.size(), {table, table});
    std::vector<Query> queries(answers.size());
    edgewise::Pose a, b;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        b.translation = {2 + static_cast<double>(i), 0, 0};
        queries[i] = {&table, &table, edgewise::relative_pose(a, b), &pairs[i]};
    }
    edgewise::query_batch<Table, Table>(queries, answers);

    double sum = 0;
    bool same = true;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        edgewise::SimplexPair<Table, Table> fresh(table, table);
        const auto single = edgewise::Gjk::query(table, table, queries[i].a_from_b, fresh);
        same = same && single.distance == answers[i].distance;
        sum += answers[i].distance;
    }
    std::printf("sum of distances %g, %s single queries\n", sum, same ? "as by" : "NOT as by");
}
