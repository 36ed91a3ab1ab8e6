// SPDX-License-Identifier: MIT
//
// A shape at many scales from one table: views that stretch it along its axes, as level editors have them.
// Nothing is built for a scale. GJK answers over views; V-Clip needs a table of the stretched body.
#include <cstdio>
#include <edgewise/algorithms/gjk.hpp>
#include <edgewise/geometry/hull.hpp>
#include <edgewise/layouts/lean.hpp>
#include <edgewise/table/scaled_table.hpp>
#include <vector>

int main() {
    using Table = edgewise::lean<edgewise::f32>;
    using View = edgewise::ScaledTable<Table>;

    const std::vector<edgewise::Vec3d> points = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                                 {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
    const auto body = edgewise::convex_hull(points);
    if (!body) {
        std::fprintf(stderr, "%s\n", body.error.c_str());
        return 1;
    }
    const Table cube(*body, edgewise::Parts::support);  // one for all

    const View plank(cube, {4, 0.5, 0.25}), post(cube, {0.5, 3, 0.5});
    edgewise::SimplexPair<View, View> pair(plank, post);  // one per pair of instances, kept between frames
    edgewise::Pose at_plank, at_post;
    for (const double x : {6.0, 5.0, 4.0}) {
        at_post.translation = {x, 0, 0};
        const auto plank_from_post = edgewise::relative_pose(at_plank, at_post);
        const edgewise::Distance answer = edgewise::Gjk::query(plank, post, plank_from_post, pair);
        std::printf("%s %g\n", to_string(answer.status).data(), answer.distance);
    }
}
