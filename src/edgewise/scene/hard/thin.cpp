// SPDX-License-Identifier: MIT
//
// Families of thin bodies: 1e-11 to 1e-5 of their extent thick, between what counts as flat (1e-12) and what
// other families call a sliver. Their planes are known no better than the bodies are thick, so an edge that
// lies in a face, or two faces that cross, look separated along one plane and deep along another.
#include <array>
#include <cmath>

#include "edgewise/scene/hard/families.hpp"

namespace edgewise::scene::hard {

namespace {

constexpr int thinnest = -36, thickest = -18;  ///< powers of two, of the extent

/// The nearest rotation matrix of numbers in single precision: 1e-7 from orthogonal.
Mat3d rounded_to_single(const Mat3d& rotation) { return rotation.cast<float>().cast<double>(); }

std::vector<Vec3d> thin_body(Maker& maker) {
    const double thin = maker.spread(thinnest, thickest);
    const double narrow = maker.spread(-11, -1);
    switch (maker.rng.below(6)) {
        case 0:
            return {{1, 0, 0}, {-1, 0, 0}, {0, 1, thin}, {0, -1, thin}, {0, 0, -thin}};  // a folded plate
        case 1:
            return Maker::box(1, maker.rng.uniform(0.2, 1), thin);
        case 2:
            return Maker::box(1, thin, maker.pick({thin, narrow}));  // a needle, a blade
        case 3:
            return {{0, 0, 0}, {1, 0, 0}, {0, thin, 0}, {0, 0, narrow}};
        case 4:
            return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.25, thin}};
        default:
            return maker.random_points(4 + maker.rng.below(9), Vec3d(1, 1, thin));
    }
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
    switch (maker.rng.below(4)) {
        case 0:
            return thin;
        case 1:
            return thin_body(maker);
        case 2:
            return flat_body(maker);
        default:
            return maker.any_solid();
    }
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

/// Where B lies: at A's own place, shifted in the plane, and out of it by about the thickness.
Vec3d place_of(Maker& maker) {
    Vec3d place = Vec3d::Zero();
    if (maker.rng.below(2) == 0) place = maker.rng.in_cube(1).cwiseProduct(Vec3d(1, 1, 0));
    if (maker.rng.below(2) == 0) place.z() = maker.either_sign(maker.spread(thinnest - 4, thickest + 4));
    return place;
}

struct ThinBodies {
    CaseBody a, b;
};

/// In every eighth pair one body is up to a million times as large.
ThinBodies thin_bodies_of(Maker& maker) {
    ThinBodies bodies{{"a", thin_body(maker), {}}, {"b", {}, {}}};
    bodies.b.vertices = partner_of(maker, bodies.a.vertices);
    if (maker.rng.below(2) == 0) std::swap(bodies.a.vertices, bodies.b.vertices);
    if (maker.rng.below(8) == 0) {
        const double factor = maker.spread(0, 20);
        for (Vec3d& v : bodies.b.vertices) v *= factor;
    }
    return bodies;
}

}  // namespace

Pair thin_bodies(Maker& maker) {
    auto [a, b] = thin_bodies_of(maker);
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
    constexpr int steps = 50;
    auto [a, b] = thin_bodies_of(maker);
    Pair pair{std::move(a), std::move(b), {}};
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
