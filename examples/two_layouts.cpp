// SPDX-License-Identifier: MIT
//
// The same body in two layouts: the bytes of each, and the distance that each computes. The algorithm is a
// template over the table, so another layout is another type and nothing else.
#include <cstdio>
#include <edgewise/algorithms/vclip.hpp>
#include <edgewise/geometry/hull.hpp>
#include <edgewise/layouts/aos.hpp>
#include <edgewise/layouts/lean.hpp>
#include <vector>

template <class Table>
void show(const edgewise::Polyhedron& body, const edgewise::Pose& a, const edgewise::Pose& b) {
    const Table table(body, edgewise::Parts::features);
    edgewise::FeaturePair<Table, Table> pair(table, table);
    const auto answer = edgewise::VClip::query(table, table, edgewise::relative_pose(a, b), pair);
    std::size_t bytes = 0;
    for (const std::size_t component : table.ledger().bytes) bytes += component;
    std::printf("%s %zu bytes, distance %.6f\n", Table::name.data(), bytes, answer.distance);
}

int main() {
    const std::vector<edgewise::Vec3d> points = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                                 {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
    const auto cube = edgewise::convex_hull(points);
    if (!cube) {
        std::fprintf(stderr, "%s\n", cube.error.c_str());
        return 1;
    }
    edgewise::Pose a, b;
    b.translation = {3, 0.25, 0.5};
    show<edgewise::aos<edgewise::f64>>(*cube, a, b);   // the paper's record: every plane is stored
    show<edgewise::lean<edgewise::f32>>(*cube, a, b);  // rings and vertices: planes are computed
}
