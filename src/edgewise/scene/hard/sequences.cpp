// SPDX-License-Identifier: MIT
//
// Families 17 and 18, many poses of one pair, asked in order with the pair's cache kept; and families of thin
// bodies, at rest and in motion: 1e-11 to 1e-5 of their extent thick, between what counts as flat (1e-12) and
// what other families call a sliver. Their planes are known no better than the bodies are thick, so an edge
// that lies in a face, or two faces that cross, look separated along one plane and deep along another.
#include <array>

#include "edgewise/scene/hard/families.hpp"

namespace edgewise::scene::hard {

namespace {

constexpr int steps = 50;

/// Moves B over a face at a constant gap, along a direction of the face.
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

constexpr int thinnest = -36, thickest = -18;  ///< powers of two, of the extent

/// The nearest rotation matrix of numbers in single precision: 1e-7 from orthogonal.
Mat3d rounded_to_single(const Mat3d& rotation) { return rotation.cast<float>().cast<double>(); }

std::vector<Vec3d> thin_body(Maker& maker) {
    const double thin = maker.spread(thinnest, thickest);
    const double narrow = maker.spread(-11, -1);
    const auto kind = maker.rng.below(6);
    if (kind == 0)  // a folded plate
        return {{1, 0, 0}, {-1, 0, 0}, {0, 1, thin}, {0, -1, thin}, {0, 0, -thin}};
    if (kind == 1) return Maker::box(1, maker.rng.uniform(0.2, 1), thin);
    if (kind == 2) return Maker::box(1, thin, maker.pick({thin, narrow}));  // a needle, a blade
    if (kind == 3) return {{0, 0, 0}, {1, 0, 0}, {0, thin, 0}, {0, 0, narrow}};
    if (kind == 4) return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, thin}};
    return maker.random_points(4 + maker.rng.below(9), Vec3d(1, 1, thin));
}

/// A segment or a polygon in the plane z = 0, where the thin bodies lie.
std::vector<Vec3d> flat_body(Maker& maker) {
    std::vector<Vec3d> points;
    const std::uint64_t corners = 2 + maker.rng.below(4);
    for (std::uint64_t i = 0; i < corners; ++i)
        points.push_back(maker.rng.in_cube(1).cwiseProduct(Vec3d(1, 1, 0)));
    return points;
}

std::vector<Vec3d> partner_of(Maker& maker, const std::vector<Vec3d>& thin) {
    const auto kind = maker.rng.below(4);
    if (kind == 0) return thin;
    if (kind == 1) return thin_body(maker);
    return kind == 2 ? flat_body(maker) : maker.any_solid();
}

/// How B lies to A: in one plane, turned over, turned in the plane; crossing by a small angle; or anyhow.
Mat3d turn_of(Maker& maker) {
    const auto kind = maker.rng.below(6);
    const Mat3d in_plane = Maker::turn(Vec3d::UnitZ(), maker.rng.uniform(-3, 3));
    if (kind == 0) return Mat3d::Identity();
    if (kind == 1) return maker.quarter_turn();
    if (kind == 2) return in_plane;
    const Vec3d axis(maker.rng.uniform(-1, 1), maker.rng.uniform(-1, 1), 0);
    if (kind <= 4 && max_abs(axis) > 0)
        return multiply(Maker::turn(axis, maker.either_sign(maker.spread(-50, -2))), in_plane);
    return maker.rng.rotation();
}

/// Returns the place of B: that of A, or shifted in the plane, out of it by about the thickness, or both.
Vec3d place_of(Maker& maker) {
    Vec3d place = Vec3d::Zero();
    if (maker.rng.below(2) == 0) place = maker.rng.in_cube(1).cwiseProduct(Vec3d(1, 1, 0));
    if (maker.rng.below(2) == 0) place.z() = maker.either_sign(maker.spread(thinnest - 4, thickest + 4));
    return place;
}

/// Returns two thin bodies without poses. In every eighth pair one body is up to a million times as large.
Pair thin_bodies_of(Maker& maker) {
    Pair bodies{{"a", thin_body(maker), {}}, {"b", {}, {}}, {}};
    bodies.b.vertices = partner_of(maker, bodies.a.vertices);
    if (maker.rng.below(2) == 0) std::swap(bodies.a.vertices, bodies.b.vertices);
    if (maker.rng.below(8) == 0) {
        const double factor = maker.spread(0, 20);
        for (Vec3d& v : bodies.b.vertices) v *= factor;
    }
    return bodies;
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

Pair thin_bodies(Maker& maker) {
    auto [a, b, none] = thin_bodies_of(maker);
    const Mat3d common = maker.common_rotation();
    Mat3d rotation = multiply(common, turn_of(maker));
    if (maker.rng.below(3) == 0) rotation = rounded_to_single(rotation);
    if (maker.rng.below(2) == 0)
        return at_gap(maker, std::move(a), std::move(b), common, rotation,
                      maker.either_sign(maker.spread(-45, -2)));
    const Vec3d place = multiply(common, place_of(maker));
    return at(std::move(a), std::move(b), common, rotation, place);
}

/// Slid, tilted and lifted by steps about as large as the bodies are thick, with a jump now and then.
Pair thin_bodies_in_motion(Maker& maker) {
    Pair pair = thin_bodies_of(maker);
    const double step = maker.spread(thinnest, -4);
    const bool rounds = maker.rng.below(3) == 0;
    Mat3d turn = turn_of(maker);
    Vec3d place = place_of(maker);
    for (int i = 0; i < steps; ++i) {
        pair.poses.push_back({Pose{}, Pose{rounds ? rounded_to_single(turn) : turn, place}});
        if (maker.rng.below(10) == 0) {
            turn = turn_of(maker);
            place = place_of(maker);
        } else if (maker.rng.below(2) == 0) {
            turn = multiply(Maker::turn(maker.rng.on_sphere(), maker.either_sign(step)), turn);
        } else {
            place += maker.rng.on_sphere() * step;
        }
    }
    return pair;
}

}  // namespace edgewise::scene::hard
