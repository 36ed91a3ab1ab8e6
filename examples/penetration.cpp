// SPDX-License-Identifier: MIT
//
// How deep two bodies overlap, and where to move the second one so that they only touch.
#include <cstdio>
#include <edgewise/algorithms/gjk.hpp>
#include <edgewise/algorithms/penetration.hpp>
#include <edgewise/geometry/hull.hpp>
#include <edgewise/layouts/points_soa.hpp>
#include <vector>

int main() {
    using Table = edgewise::points_soa<edgewise::f64>;  // GJK and penetration need vertices only

    const std::vector<edgewise::Vec3d> points = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                                 {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
    const auto cube = edgewise::convex_hull(points);
    if (!cube) {
        std::fprintf(stderr, "%s\n", cube.error.c_str());
        return 1;
    }
    const Table table(*cube, edgewise::Parts::support);
    edgewise::SimplexPair<Table, Table> pair(table, table);  // one per pair of bodies, kept between frames
    edgewise::PenetrationSpace space;                        // one per thread

    edgewise::Pose a, b;
    b.translation = {1.75, 0.5, 0};
    for (int step = 0; step < 2; ++step) {
        const auto a_from_b = edgewise::relative_pose(a, b);
        static_cast<void>(edgewise::Gjk::query(table, table, a_from_b, pair));  // where to start from
        const auto overlap = edgewise::penetration(table, table, a_from_b, pair, space);
        std::printf("%g deep\n", overlap.depth);
        b.translation += overlap.depth * overlap.normal;  // A's frame is the world's here
    }
}
