// SPDX-License-Identifier: MIT
//
// queries VERTICES POSES: queries of a user's program, to run under sanitizers. Compares the answers of all
// table types, so that nothing is optimised away.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/points_soa.hpp"

namespace {

using namespace edgewise;

/// Pseudo-random numbers in [-1, 1), the same for the same seed.
class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state_ >> 11) * 0x1p-52 - 1;
    }
    Vec3d unit() {
        const Vec3d v(next(), next(), next());
        return v / norm(v);
    }

  private:
    std::uint64_t state_;
};

Polyhedron body_of(int vertices) {
    Numbers numbers(3);
    std::vector<Vec3d> points;
    for (int i = 0; i < vertices; ++i) points.push_back(numbers.unit());
    return round_to_single(convex_hull(points).or_throw()).or_throw();
}

Mat3d any_rotation(Numbers& numbers) {
    Mat3d rotation;
    const Vec3d x = numbers.unit(), across = cross(x, numbers.unit()), y = across / norm(across);
    rotation << x, y, cross(x, y);
    return rotation;
}

template <class Algorithm, class Table>
double sum_of_distances(const Polyhedron& body, int poses) {
    const Table table(body, Algorithm::parts);
    typename Algorithm::template Pair<Table, Table> pair(table, table);
    Numbers numbers(5);
    double sum = 0;
    for (int i = 0; i < poses; ++i) {
        const Pose a, b{any_rotation(numbers), Vec3d(1.2, 0, 0) + 1.2 * numbers.unit()};
        sum += Algorithm::query(table, table, relative_pose(a, b), pair).distance;
    }
    return sum;
}

}  // namespace

int main(int, char** arguments) {
    const Polyhedron body = body_of(std::atoi(arguments[1]));
    const int poses = std::atoi(arguments[2]);
    const double sums[] = {
        sum_of_distances<Gjk, lean<f64>>(body, poses), sum_of_distances<Gjk, points_soa<f32>>(body, poses),
        sum_of_distances<VClip, aos<f64>>(body, poses), sum_of_distances<VClip, aos<f32>>(body, poses),
        sum_of_distances<VClip, lean<f64>>(body, poses)};
    for (const double sum : sums) {
        std::printf("%.9g ", sum);
        if (!(std::abs(sum - sums[0]) < 1e-5 * sums[0])) return 1;
    }
    std::printf("\n");
    return 0;
}
