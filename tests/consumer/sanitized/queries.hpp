// SPDX-License-Identifier: MIT
//
// Queries of a user's program, to run under sanitizers. Each source has the queries that one compiler run of
// at most 30 s can take: a query type takes 12 to 22 s with g++ -O2 -fsanitize=undefined.
#pragma once

#include <cstdint>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/pose.hpp"

namespace queries {

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

inline Mat3d any_rotation(Numbers& numbers) {
    Mat3d rotation;
    const Vec3d x = numbers.unit(), across = cross(x, numbers.unit()), y = across / norm(across);
    rotation << x, y, cross(x, y);
    return rotation;
}

/// Sum of the distances of two such bodies in some poses, always the same.
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

/// Add the sums of V-Clip's table types.
void add_vclip_in_double(const Polyhedron& body, int poses, std::vector<double>& sums);
void add_vclip_in_single(const Polyhedron& body, int poses, std::vector<double>& sums);

}  // namespace queries
