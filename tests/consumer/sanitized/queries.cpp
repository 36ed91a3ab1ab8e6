// SPDX-License-Identifier: MIT
//
// queries VERTICES POSES: compares the answers of all table types, so that nothing is optimised away.
#include "queries.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/points_soa.hpp"

namespace {

using namespace queries;

Polyhedron body_of(int vertices) {
    Numbers numbers(3);
    std::vector<Vec3d> points;
    for (int i = 0; i < vertices; ++i) points.push_back(numbers.unit());
    return round_to_single(convex_hull(points).or_throw()).or_throw();
}

}  // namespace

int main(int, char** arguments) {
    const Polyhedron body = body_of(std::atoi(arguments[1]));
    const int poses = std::atoi(arguments[2]);
    std::vector<double> sums = {sum_of_distances<Gjk, lean<f64>>(body, poses),
                                sum_of_distances<Gjk, points_soa<f32>>(body, poses)};
    add_vclip_in_double(body, poses, sums);
    add_vclip_in_single(body, poses, sums);
    for (const double sum : sums) {
        std::printf("%.9g ", sum);
        if (!(std::abs(sum - sums[0]) < 1e-5 * sums[0])) return 1;
    }
    std::printf("\n");
    return 0;
}
