// SPDX-License-Identifier: MIT
//
// "Is B nearer than the margin?" in every frame. Proven bounds of the distance answer as long as they can;
// only then a table is read. The cost is shown: queries to the tables against frames.
#include <cstdio>
#include <edgewise/algorithms/gjk.hpp>
#include <edgewise/algorithms/near_pair.hpp>
#include <edgewise/geometry/hull.hpp>
#include <edgewise/layouts/lean.hpp>
#include <vector>

int main() {
    using Table = edgewise::lean<edgewise::f64>;

    const std::vector<edgewise::Vec3d> points = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                                 {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
    const auto cube = edgewise::convex_hull(points);
    if (!cube) {
        std::fprintf(stderr, "%s\n", cube.error.c_str());
        return 1;
    }
    const Table table(*cube, edgewise::Parts::support);
    edgewise::NearPair<edgewise::Gjk, Table, Table> pair(table, table);  // kept from frame to frame

    edgewise::Pose a, b;
    int frames = 0, near = 0;
    for (double x = 10; x > 2; x -= 0.0625) {  // B comes nearer
        b.translation = {x, 0, 0};
        ++frames;
        near += pair.nearer_than(0.5, edgewise::relative_pose(a, b));
    }
    std::printf("%d of %d frames nearer than 0.5, %llu queries\n", near, frames,
                static_cast<unsigned long long>(pair.queries()));
}
