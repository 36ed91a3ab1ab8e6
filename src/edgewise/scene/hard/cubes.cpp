// SPDX-License-Identifier: MIT
//
// Six rows of poses of a cube (half extent 1) over another, on which the original V-Clip was measured with
// 10^6 poses each: cycles on lattices and at identical poses, false verdicts on quarter turns.
#include <numbers>

#include "edgewise/scene/hard/families.hpp"

namespace edgewise::scene::hard {

namespace {

Pair cubes(const Pose& pose_a, const Pose& pose_b) {
    return {{"a", Maker::box(1, 1, 1), {}}, {"b", Maker::box(1, 1, 1), {}}, {{pose_a, pose_b}}};
}

/// Multiples of a step, up to 2.5 either way.
Vec3d on_lattice(Maker& maker, double step, int most) {
    Vec3d place;
    for (double& x : place) {
        x = step * (static_cast<int>(maker.rng.below(static_cast<std::uint64_t>(2 * most + 1))) - most);
    }
    return place;
}

}  // namespace

Pair cubes_random(Maker& maker) {
    return cubes({maker.rng.rotation(), Vec3d::Zero()}, {maker.rng.rotation(), maker.rng.in_cube(2.5)});
}

Pair cubes_near_parallel(Maker& maker) {
    const Mat3d rotation = maker.rng.rotation();
    const Mat3d tilt = Maker::turn(maker.rng.on_sphere(), maker.spread(-29, -1));
    return cubes({rotation, Vec3d::Zero()}, {multiply(rotation, tilt), maker.rng.in_cube(2.5)});
}

Pair cubes_half_lattice(Maker& maker) { return cubes({}, {Mat3d::Identity(), on_lattice(maker, 0.5, 5)}); }

Pair cubes_identical_pose(Maker& maker) {
    const Pose pose{maker.rng.rotation(), maker.rng.in_cube(2)};
    return cubes(pose, pose);
}

Pair cubes_45_degrees(Maker& maker) {
    return cubes({}, {Maker::turn(Vec3d(0, 0, 1), std::numbers::pi / 4), on_lattice(maker, 0.5, 5)});
}

Pair cubes_quarter_turns(Maker& maker) {
    return cubes({}, {maker.quarter_turn(), on_lattice(maker, 0.05, 50)});
}

}  // namespace edgewise::scene::hard
