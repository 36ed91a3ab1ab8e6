// SPDX-License-Identifier: MIT
//
// GJK on the canonical bodies places the pairs. Its errors do no harm, because every pair is checked by its
// exact distance and the test asserts that all regimes occurred.
#include "random_pairs.hpp"

#include <cmath>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/scene/motion.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise {
namespace {

Distance canonical_distance(const Polyhedron& a, const Polyhedron& b, const RandomPair& pair) {
    SimplexPair<Canonical, Canonical> cold;
    return Gjk::query(Canonical(a), Canonical(b), relative_pose(pair.pose_a, pair.pose_b), cold);
}

/// A rotation by quarter turns, without rounding.
Mat3d quarter_turns(scene::Rng& rng) {
    Mat3d turn = Mat3d::Zero();
    const auto first = static_cast<int>(rng.below(3));
    for (int row = 0; row < 3; ++row) turn(row, (row + first) % 3) = 1;  // a cyclic order is a rotation
    if (rng.below(2) == 0) turn.topRows(2) *= -1;
    return turn;
}

/// A random number between 2^-low and 2^-high; all its orders of magnitude are equally likely.
double power(scene::Rng& rng, int low, int high) {
    const auto exponent = low + static_cast<int>(rng.below(static_cast<std::uint64_t>(high - low)));
    return std::ldexp(rng.uniform(0.5, 1), -exponent);
}

}  // namespace

PairMaker::PairMaker(const Polyhedron& a, const Polyhedron& b, std::uint64_t seed)
    : a_(a), b_(b), rng_(seed), size_(std::max(extent(a.vertices), extent(b.vertices))) {}

RandomPair PairMaker::next() {
    const int turn = count_++ % 10;
    RandomPair pair;
    pair.relation = turn < 6   ? Relation::generic
                    : turn < 8 ? Relation::nearly_parallel
                    : turn < 9 ? Relation::identical
                               : Relation::lattice;
    if (pair.relation == Relation::lattice) {
        place_on_lattice(pair);
    } else {
        orient(pair);
        place(pair);
    }
    return pair;
}

void PairMaker::orient(RandomPair& pair) {
    const scene::Quaternion of_a = rng_.orientation();
    scene::Quaternion of_b = of_a;
    if (pair.relation == Relation::generic) of_b = rng_.orientation();
    if (pair.relation == Relation::nearly_parallel) {
        const Vec3d axis = rng_.on_sphere();
        of_b = normalised(scene::rotation_about(axis, power(rng_, 2, 54)) * of_a);
    }
    pair.pose_a.rotation = scene::rotation_matrix(of_a);
    pair.pose_b.rotation = scene::rotation_matrix(of_b);
}

/// Places B by quarter turns and by quarters of the largest coordinate: gives parallel faces, exact contact,
/// and edges on edges.
void PairMaker::place_on_lattice(RandomPair& pair) {
    double largest = 0;
    for (const Vec3d& v : a_.vertices) largest = std::max(largest, max_abs(v));
    pair.pose_a.rotation = quarter_turns(rng_);
    pair.pose_b.rotation = quarter_turns(rng_);
    const Vec3d steps = rng_.in_cube(9.5).array().round();
    pair.pose_b.translation = steps * (largest / 4);
}

double PairMaker::wanted_gap() {
    switch (rng_.below(8)) {
        case 0:
            return size_ * rng_.uniform(0.1, 3);
        case 1:
            return size_ * power(rng_, 3, 10);
        case 2:
        case 3:
        case 4:
            return size_ * power(rng_, 10, 30);
        case 5:
            return -size_ * rng_.uniform(0, 0.2);
        default:
            return -size_ * power(rng_, 3, 30);
    }
}

/// Offset of B along the direction for a gap of a fiftieth of the size.
double PairMaker::near_offset(const RandomPair& pair, const Vec3d& direction) const {
    double low = 0, high = 2 * size_;
    for (int i = 0; i < 10; ++i) {
        RandomPair tried = pair;
        tried.pose_b.translation += direction * (low + high) / 2;
        (canonical_distance(a_, b_, tried).distance < size_ / 50 ? low : high) = (low + high) / 2;
    }
    return high;
}

void PairMaker::place(RandomPair& pair) {
    pair.pose_a.translation = rng_.in_cube(4);
    pair.pose_b.translation = pair.pose_a.translation;
    const Vec3d direction = rng_.on_sphere();
    if (rng_.below(16) == 0) {  // one inside the other
        pair.pose_b.translation += direction * (size_ * rng_.uniform(0, 0.3));
        return;
    }
    const bool start_near = rng_.below(2) == 0;
    pair.pose_b.translation += direction * (start_near ? near_offset(pair, direction) : 4 * size_);
    const Distance start = canonical_distance(a_, b_, pair);
    const Vec3d apart = multiply(pair.pose_a.rotation, Vec3d(start.point_b - start.point_a));
    if (!(start.distance > 0)) return;
    pair.gap = wanted_gap();
    pair.pose_b.translation += apart * ((pair.gap - start.distance) / norm(apart));
}

}  // namespace edgewise
