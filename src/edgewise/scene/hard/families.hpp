// SPDX-License-Identifier: MIT
//
// The hard-case families: seeded generators of pairs that broke some collision library, each with the regime
// it sweeps, and six rows of cube poses on which the original V-Clip was measured. One line per family in
// families.cpp; the generators are in files named after what they vary.
//
// The families are made of spread-out numbers, rotations, small bodies as point lists, and pairs placed at a
// wanted gap. IEEE + - * / sqrt and scaling by powers of two only, so the cases have the same bits
// everywhere; "spread" means a power of two, uniform over the octaves, times 1 to 2.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "edgewise/geometry/pose.hpp"
#include "edgewise/scene/case_file.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::scene {

namespace hard {

/// Two bodies and where they are, in time order.
struct Pair {
    CaseBody a, b;
    std::vector<std::pair<Pose, Pose>> poses;
};

class Maker {
  public:
    /// `single`: cases for tables that store in single precision, where offsets and scales must stay in
    /// range. `real`: bodies from mesh files; may be empty.
    Maker(std::uint64_t seed, bool single, std::span<const Polyhedron> real)
        : rng(seed), single_(single), real_(real) {}

    Rng rng;

    [[nodiscard]] bool single() const { return single_; }
    [[nodiscard]] std::span<const Polyhedron> real() const { return real_; }

    /// About log-uniform in [2^low, 2^(high + 1)).
    [[nodiscard]] double spread(int low, int high);
    [[nodiscard]] double either_sign(double x) { return rng.below(2) == 0 ? x : -x; }
    template <class T>
    [[nodiscard]] T pick(std::initializer_list<T> choices) {
        return choices.begin()[rng.below(choices.size())];
    }

    /// One of the 24 rotations that map the axes onto one another; exact.
    [[nodiscard]] Mat3d quarter_turn();
    /// Returns a rotation by any angle (radians) about any axis except zero.
    [[nodiscard]] static Mat3d turn(const Vec3d& axis, double angle);
    /// Returns the identity, 45 degrees about an axis, or a random rotation.
    [[nodiscard]] Mat3d common_rotation();

    [[nodiscard]] static std::vector<Vec3d> box(double x, double y, double z);  ///< half extents
    /// Corners on a circle of radius 1, times 2 * half_height.
    [[nodiscard]] static std::vector<Vec3d> prism(int corners, double half_height);
    [[nodiscard]] static std::vector<Vec3d> octahedron();
    [[nodiscard]] static std::vector<Vec3d> icosahedron();
    [[nodiscard]] std::vector<Vec3d> random_points(std::size_t count, const Vec3d& half);
    /// A box, prism or random hull about one across.
    [[nodiscard]] std::vector<Vec3d> any_solid();

  private:
    bool single_;
    std::span<const Polyhedron> real_;
};

/// One pose of both, A at the origin.
[[nodiscard]] inline Pair at(CaseBody a, CaseBody b, const Mat3d& rotation_a, const Mat3d& rotation_b,
                             const Vec3d& place_b) {
    return {std::move(a), std::move(b), {{Pose{rotation_a, Vec3d::Zero()}, Pose{rotation_b, place_b}}}};
}

/// Moves B along the line of closest approach until the gap is as wanted, to rounding; negative gaps overlap
/// by about as much. B must be separated from A, else it is first moved off along `away`.
void set_gap(const CaseBody& a, const Pose& pose_a, const CaseBody& b, Pose& pose_b, const Vec3d& away,
             double gap);

/// Both bodies at random orientation, B in a random direction at that gap.
[[nodiscard]] Pair at_gap(Maker& maker, CaseBody a, CaseBody b, const Mat3d& rotation_a,
                          const Mat3d& rotation_b, double gap);

using Family = Pair(Maker&);

Family parallel_faces, near_parallel_faces, near_parallel_edges, voronoi_straddle, noisy_rotation;
Family grazing, exact_touch, deep_and_concentric, tie_rich_solids;
Family slivers_and_needles, scale_disparity, absolute_scale, large_offset, far_apart, extreme_numbers;
Family duplicates, near_coplanar_vertices, flat_bodies, thin_beams, random_fuzz, real_hulls_at_gaps;
Family thin_bodies, thin_bodies_in_motion, coherent_motion, bad_warm_start;
Family cubes_random, cubes_near_parallel, cubes_half_lattice, cubes_identical_pose, cubes_45_degrees,
    cubes_quarter_turns;

}  // namespace hard

struct HardFamily {
    std::string name;
    std::string varies;  ///< one line
    std::string breaks;  ///< what such pairs broke elsewhere
    std::function<hard::Pair(hard::Maker&)> make;
    bool warm = false;  ///< the poses of a pair follow each other, and its cache is kept
};

/// Returns all families, in the order of the report.
[[nodiscard]] std::span<const HardFamily> hard_families();

}  // namespace edgewise::scene
