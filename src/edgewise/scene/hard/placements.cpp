// SPDX-License-Identifier: MIT
//
// Families 1 to 5, 14 to 16 and 19: how two bodies lie to each other. Sides that are parallel or nearly,
// frames that are not quite frames; just separated, just touching, deep inside, and every support value
// twice.
#include <cmath>
#include <numbers>

#include "edgewise/scene/hard/families.hpp"

namespace edgewise::scene::hard {

namespace {

std::vector<Vec3d> box_or_prism(Maker& maker) {
    if (maker.rng.below(3) == 0) return Maker::prism(3 + static_cast<int>(maker.rng.below(6)), 0.5);
    return Maker::box(maker.pick({0.25, 0.5, 1.0}), maker.pick({0.25, 0.5, 1.0}), 0.5);
}

/// B on top of A (both half a unit high) in A's frame, then both turned.
Pair stacked(Maker& maker, CaseBody a, CaseBody b, const Mat3d& common, const Mat3d& tilt, double gap) {
    const Vec3d lateral(maker.pick({0.0, 0.5, 1.0, 0.75}), maker.pick({0.0, 0.5, 1.0, -0.25}), 1 + gap);
    return at(std::move(a), std::move(b), common, multiply(common, tilt), multiply(common, lateral));
}

int finest(const Maker& maker) { return maker.single() ? -30 : -60; }

}  // namespace

Pair parallel_faces(Maker& maker) {
    const double step = std::ldexp(1.0, finest(maker) + static_cast<int>(maker.rng.below(30)) * 2);
    const double gap = maker.rng.below(5) == 0 ? 0 : maker.either_sign(step / 2);
    CaseBody a{"a", box_or_prism(maker), {}}, b{"b", box_or_prism(maker), {}};
    return stacked(maker, std::move(a), std::move(b), maker.common_rotation(), Mat3d::Identity(), gap);
}

Pair near_parallel_faces(Maker& maker) {
    const double tilt = maker.either_sign(maker.spread(finest(maker) + 8, -4));
    CaseBody a{"a", box_or_prism(maker), {}}, b{"b", box_or_prism(maker), {}};
    const Mat3d common = maker.common_rotation();
    const double gap = (maker.rng.below(3) == 0 ? -1 : 1) * maker.spread(-40, -4);
    const Vec3d axis =
        maker.pick({Vec3d(1, 0.5, 3), Vec3d(1, 1, 1), Vec3d(1, 0, 1), Vec3d(1, 0, 0), Vec3d(0, 1, 0)});
    return at_gap(maker, std::move(a), std::move(b), common, multiply(common, Maker::turn(axis, tilt)), gap);
}

Pair near_parallel_edges(Maker& maker) {
    CaseBody a{"a", Maker::box(1.5, 0.1, 0.1), {}}, b{"b", Maker::box(1.5, 0.1, 0.1), {}};
    const double cross = maker.rng.below(6) == 0 ? 0 : maker.spread(finest(maker) + 20, -2);
    const double gap = maker.either_sign(maker.spread(-40, -5));
    const Mat3d roll = Maker::turn(Vec3d(1, 0, 0), std::numbers::pi / 4);
    const Mat3d turned = multiply(Maker::turn(Vec3d(0, 0, 1), cross), roll);
    const Vec3d along(maker.pick({0.0, 0.7, 3.0, 1.5}), 0, 0.2 * std::sqrt(2.0) + gap);
    const Mat3d common = maker.common_rotation();
    return at(std::move(a), std::move(b), multiply(common, roll), multiply(common, turned),
              multiply(common, along));
}

/// A tetrahedron's tip over a box, near the plane between the regions of its top and of its side or edge.
Pair voronoi_straddle(Maker& maker) {
    CaseBody a{"a", Maker::box(0.5, 0.5, 0.5), {}};
    CaseBody b{"b", {{0, 0, 0}, {0.5, 0.25, 1}, {-0.5, 0.25, 1}, {0, -0.5, 1}}, {}};
    const double ulp = maker.single() ? 0x1p-24 : 0x1p-53;
    const double shift = maker.either_sign(maker.pick({0.0, ulp, 1e-12, 1e-7, 4 * ulp}));
    const double height = maker.pick({0.5, 0x1p-10, 0x1p-20, 0.125});
    Vec3d tip(0.5 + shift, maker.pick({0.0, 0.5, 0.25}), 0.5 + height);
    if (maker.rng.below(2) == 0) tip.z() = 0.5 + maker.either_sign(maker.pick({0.0, ulp, 1e-7}));
    const Mat3d common = maker.common_rotation();
    return at(std::move(a), std::move(b), common, common, multiply(common, tip));
}

Pair noisy_rotation(Maker& maker) {
    CaseBody a{"a", maker.any_solid(), {}}, b{"b", maker.any_solid(), {}};
    Mat3d rotation_a = maker.rng.rotation(), rotation_b = maker.rng.rotation();
    const double noise = maker.pick({1e-16, 1e-12, 1e-7, 1e-4});
    for (Mat3d* rotation : {&rotation_a, &rotation_b}) {
        for (int i = 0; i < 9; ++i) (*rotation)(i / 3, i % 3) += maker.rng.uniform(-noise, noise);
    }
    const double gap = maker.either_sign(maker.spread(-20, 0));
    return at_gap(maker, std::move(a), std::move(b), rotation_a, rotation_b, gap);
}

Pair grazing(Maker& maker) {
    CaseBody a{"a", maker.any_solid(), {}}, b{"b", maker.any_solid(), {}};
    const double step = maker.single() ? 0x1p-23 : 0x1p-52;
    const int octave = static_cast<int>(maker.rng.below(25)) - 4;
    const double gap = maker.pick({-1.0, 0.0, 1.0}) * std::ldexp(step, octave);
    return at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap);
}

/// Boxes with dyadic sizes and offsets, turned by quarters only: nothing is rounded, the touch is exact.
Pair exact_touch(Maker& maker) {
    const auto size = [&] { return maker.pick({0.25, 0.5, 1.0, 2.0}); };
    const Vec3d half_a(size(), size(), size()), half_b(size(), size(), size());
    const bool octahedral = maker.rng.below(4) == 0;
    CaseBody a{"a", Maker::box(half_a.x(), half_a.y(), half_a.z()), {}};
    CaseBody b{"b", Maker::box(half_b.x(), half_b.y(), half_b.z()), {}};
    if (octahedral) {
        b.vertices = Maker::octahedron();
        for (Vec3d& v : b.vertices) v = v.cwiseProduct(half_b);
    }
    // At least one axis touches; on the others the boxes touch, meet in part, or share a side.
    Vec3d offset;
    for (int i = 0; i < 3; ++i) {
        const double sum = half_a[i] + half_b[i];
        offset[i] = maker.either_sign(octahedral ? maker.pick({0.0, half_a[i] / 2})
                                                 : maker.pick({sum, sum / 2, half_a[i] - half_b[i], 0.0}));
    }
    const int axis = static_cast<int>(maker.rng.below(3));
    offset[axis] = maker.either_sign(half_a[axis] + half_b[axis]);
    const Mat3d turn = maker.quarter_turn();
    return at(std::move(a), std::move(b), turn, turn, multiply(turn, offset));
}

Pair deep_and_concentric(Maker& maker) {
    CaseBody a{"a", maker.any_solid(), {}}, b{"b", maker.any_solid(), {}};
    if (maker.rng.below(2) == 0) b.vertices = a.vertices;
    const double ratio = maker.rng.uniform(0.01, 1);
    for (Vec3d& v : b.vertices) v *= ratio;
    const double off = maker.rng.below(3) == 0 ? 0 : maker.spread(-53, -4);
    const Mat3d common = maker.common_rotation();
    const Mat3d turned = maker.rng.below(2) == 0 ? common : maker.rng.rotation();
    return at(std::move(a), std::move(b), common, turned, maker.rng.on_sphere() * off);
}

Pair tie_rich_solids(Maker& maker) {
    const auto solid = [&]() -> std::vector<Vec3d> {
        const auto kind = maker.rng.below(4);
        if (kind == 0) return Maker::box(1, 1, 1);
        if (kind == 1) return Maker::octahedron();
        if (kind == 2) return Maker::icosahedron();
        return Maker::prism(4 * (1 + static_cast<int>(maker.rng.below(8))), 1);
    };
    CaseBody a{"a", solid(), {}}, b{"b", solid(), {}};
    const Vec3d lateral(maker.pick({0.0, 1.0, 0.5}), maker.pick({0.0, 1.0, 0.5}), 0);
    const double height = maker.pick({1.5, 2.0, 2.25, 3.0, 4.0});
    const Mat3d common = maker.rng.below(2) == 0 ? maker.quarter_turn() : maker.rng.rotation();
    const Vec3d place = multiply(common, Vec3d(lateral + Vec3d(0, 0, height)));
    return at(std::move(a), std::move(b), common, multiply(common, maker.quarter_turn()), place);
}

// Six rows of poses of a cube (half extent 1) over another, on which the original V-Clip was measured with
// 10^6 poses each: cycles on lattices and at identical poses, false verdicts on quarter turns.

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
