// SPDX-License-Identifier: MIT
//
// Families 17 and 18: many poses of one pair, asked in order with the pair's cache kept.
#include <array>

#include "edgewise/scene/hard/families.hpp"

namespace edgewise::scene::hard {

namespace {

constexpr int steps = 50;

/// Over a face at a constant gap, along a direction of the face.
void slide(Maker& maker, Pair& pair, const Mat3d& common) {
    const double gap = maker.either_sign(maker.spread(-40, -4));
    const Vec3d way = maker.pick({Vec3d(1, 0, 0), Vec3d(1, 1, 0), Vec3d(0.5, 1, 0)}) * 0.05;
    for (int i = 0; i < steps; ++i) {
        const Vec3d place = Vec3d(-1.2, -0.3, 1 + gap) + way * i;
        pair.poses.push_back({Pose{common, Vec3d::Zero()}, Pose{common, multiply(common, place)}});
    }
}

/// About an axis that keeps an edge parallel to a face.
void roll(Maker& maker, Pair& pair, const Mat3d& common) {
    const double angle = maker.spread(-20, -3);
    const Vec3d axis = maker.pick({Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(1, 1, 1)});
    Mat3d turned = common;
    const Mat3d once = Maker::turn(axis, angle);
    for (int i = 0; i < steps; ++i) {
        const Vec3d place(0.25, 0.125, 1.25);
        pair.poses.push_back({Pose{common, Vec3d::Zero()}, Pose{turned, multiply(common, place)}});
        turned = multiply(turned, once);
    }
}

/// To and fro across contact, then straight through.
void approach(Maker& maker, Pair& pair, const Mat3d& common) {
    const double swing = maker.spread(-40, -4);
    for (int i = 0; i < steps; ++i) {
        const double height = i < steps / 2 ? (i % 2 == 0 ? swing : -swing) : -0.1 * (i - steps / 2);
        const Vec3d place(0.25, 0.125, 1 + height);
        pair.poses.push_back({Pose{common, Vec3d::Zero()}, Pose{common, multiply(common, place)}});
    }
}

}  // namespace

Pair coherent_motion(Maker& maker) {
    Pair pair{{"a", Maker::box(0.5, 0.5, 0.5), {}}, {"b", Maker::box(0.5, 0.5, 0.5), {}}, {}};
    if (maker.rng.below(2) == 0)
        pair.b.vertices = Maker::prism(3 + static_cast<int>(maker.rng.below(8)), 0.5);
    const Mat3d common = maker.common_rotation();
    constexpr std::array ways = {slide, roll, approach};
    ways[maker.rng.below(ways.size())](maker, pair, common);
    return pair;
}

Pair bad_warm_start(Maker& maker) {
    Pair pair{{"a", maker.any_solid(), {}}, {"b", maker.any_solid(), {}}, {}};
    for (int i = 0; i < steps; ++i) {
        Pose pose_b{maker.rng.rotation(), Vec3d(maker.rng.on_sphere() * 4)};
        set_gap(pair.a, Pose{}, pair.b, pose_b, Vec3d::UnitX(), maker.either_sign(maker.spread(-20, 0)));
        pair.poses.push_back({Pose{}, pose_b});
    }
    return pair;
}

}  // namespace edgewise::scene::hard
