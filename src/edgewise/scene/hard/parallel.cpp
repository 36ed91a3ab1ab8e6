// SPDX-License-Identifier: MIT
//
// Families 1 to 3, 16 and 19: sides that are parallel or nearly, and frames that are not quite frames.
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

Vec3d tilt_axis(Maker& maker) {
    return maker.pick({Vec3d(1, 0.5, 3), Vec3d(1, 1, 1), Vec3d(1, 0, 1), Vec3d(1, 0, 0), Vec3d(0, 1, 0)});
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
    return at_gap(maker, std::move(a), std::move(b), common,
                  multiply(common, Maker::turn(tilt_axis(maker), tilt)), gap);
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

}  // namespace edgewise::scene::hard
