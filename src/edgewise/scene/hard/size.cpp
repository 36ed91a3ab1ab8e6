// SPDX-License-Identifier: MIT
//
// Families 6 to 10 and 20: bodies that are thin, of unlike size, tiny, huge, far off, or far apart.
#include <cmath>

#include "edgewise/scene/hard/families.hpp"

namespace edgewise::scene::hard {

namespace {

void scale(CaseBody& body, double factor) {
    for (Vec3d& v : body.vertices) v *= factor;
}

std::vector<Vec3d> thin(Maker& maker) {
    const double small = maker.spread(maker.single() ? -12 : -27, -1);
    const auto kind = maker.rng.below(4);
    if (kind == 0) return {{0, 0, 0}, {1, 0, 0}, {0.5, small, 0}};
    if (kind == 1) return Maker::box(1, 1, small);
    if (kind == 2) return Maker::box(1, small, small);
    return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, small}};
}

}  // namespace

Pair slivers_and_needles(Maker& maker) {
    CaseBody a{"a", thin(maker), {}}, b{"b", maker.rng.below(2) == 0 ? thin(maker) : maker.any_solid(), {}};
    const double gap = (maker.rng.below(3) == 0 ? -1 : 1) * maker.spread(-30, 1);
    return at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap);
}

/// The gap is relative to the small body.
Pair scale_disparity(Maker& maker) {
    CaseBody a{"a", maker.any_solid(), {}}, b{"b", maker.any_solid(), {}};
    const double ratio = maker.spread(maker.single() ? -13 : -26, -1);
    scale(b, ratio);
    const double gap = maker.either_sign(ratio * maker.spread(-30, -1));
    if (maker.rng.below(2) == 0) std::swap(a.vertices, b.vertices);
    return at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap);
}

Pair absolute_scale(Maker& maker) {
    const int most = maker.single() ? 20 : 60;
    const double factor = std::ldexp(1.0, static_cast<int>(maker.rng.below(2 * most + 1)) - most);
    CaseBody a{"a", maker.any_solid(), {}}, b{"b", maker.any_solid(), {}};
    const double gap = (maker.rng.below(3) == 0 ? -1 : 1) * maker.spread(-20, 1);
    Pair pair = at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap);
    scale(pair.a, factor);
    scale(pair.b, factor);
    for (auto& [pose_a, pose_b] : pair.poses) {
        pose_a.translation *= factor;
        pose_b.translation *= factor;
    }
    return pair;
}

/// Adds offsets to the translations, to the vertices, or to both so that they cancel. They are powers of two,
/// so that the bodies keep as many digits as possible.
Pair large_offset(Maker& maker) {
    CaseBody a{"a", maker.any_solid(), {}}, b{"b", maker.any_solid(), {}};
    const double gap = (maker.rng.below(3) == 0 ? -1 : 1) * maker.spread(-10, 1);
    const double far = std::ldexp(1.0, static_cast<int>(maker.rng.below(maker.single() ? 20 : 40)));
    const Vec3d offset = maker.quarter_turn().col(0) * far + maker.quarter_turn().col(1) * far;
    Pair pair = at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap);
    auto& [pose_a, pose_b] = pair.poses.front();
    const auto where = maker.rng.below(3);
    if (where == 0) {
        pose_a.translation += offset;
        pose_b.translation += offset;
        return pair;
    }
    for (Vec3d& v : pair.a.vertices) v += offset;
    if (where == 2) {
        pose_a.translation -= multiply(pose_a.rotation, offset);
    } else {
        pose_b.translation += multiply(pose_a.rotation, offset);
    }
    return pair;
}

Pair far_apart(Maker& maker) {
    CaseBody a{"a", maker.any_solid(), {}}, b{"b", maker.any_solid(), {}};
    const double gap = maker.spread(1, maker.single() ? 20 : 26);
    return at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap);
}

/// Whole scenes scaled to where products of coordinates leave the range of the type; some are refused, with a
/// reason, none may hang or answer NaN.
Pair extreme_numbers(Maker& maker) {
    Pair pair = absolute_scale(maker);
    const int exponent = maker.single()
                             ? maker.pick({-149, -140, -110, -76, -40, 40, 63, 100, 126})
                             : maker.pick({-1060, -900, -530, -300, -130, -90, 90, 130, 300, 480, 800, 960});
    for (CaseBody* body : {&pair.a, &pair.b}) {
        for (Vec3d& v : body->vertices) {
            for (double& x : v) x = std::ldexp(x == 0 ? -0.0 : x, exponent);
        }
    }
    for (auto& [pose_a, pose_b] : pair.poses) {
        for (double& x : pose_b.translation) x = std::ldexp(x, exponent);
    }
    return pair;
}

}  // namespace edgewise::scene::hard
