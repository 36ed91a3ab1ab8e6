// SPDX-License-Identifier: MIT
//
// Families 6 to 13 and 20 to 23: the bodies that users hand in. Thin, of unlike size, tiny, huge, far off, or
// far apart; with copied vertices, nearly flat corners, or flat.
#include <cmath>

#include "edgewise/scene/hard/families.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"

namespace edgewise::scene::hard {

namespace {

Pair at_some_gap(Maker& maker, CaseBody a, CaseBody b, int finest, int coarsest) {
    const double gap = (maker.rng.below(3) == 0 ? -1 : 1) * maker.spread(finest, coarsest);
    return at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap);
}

/// A cube with two triangles for each side.
CaseBody split_cube() {
    CaseBody cube{"a", Maker::box(0.5, 0.5, 0.5), {}};
    cube.faces =
        std::vector<std::vector<Index>>{{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                        {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return cube;
}

/// A cube with vertices in the middle of its sides and edges, off by some noise or none.
CaseBody studded_cube(Maker& maker) {
    CaseBody cube{"a", Maker::box(0.5, 0.5, 0.5), {}};
    const double noise = maker.rng.below(2) == 0 ? 0 : maker.spread(-53, -10);
    for (int i = 0; i < 12; ++i) {
        Vec3d stud = maker.rng.in_cube(0.5);
        const auto axis = maker.rng.below(3);
        stud[static_cast<Eigen::Index>(axis)] = maker.either_sign(0.5) + maker.rng.uniform(-noise, noise);
        if (i % 3 == 0) stud[static_cast<Eigen::Index>((axis + 1) % 3)] = 0.5;
        cube.vertices.push_back(stud);
    }
    return cube;
}

std::vector<Vec3d> flat_points(Maker& maker) {
    const auto kind = maker.rng.below(5);
    if (kind == 0) return {maker.rng.in_cube(1)};
    if (kind == 1) return {maker.rng.in_cube(1), maker.rng.in_cube(1)};
    if (kind == 2) return {{0, 0, 0}, {0.5, 0.25, 0.125}, {1, 0.5, 0.25}};
    if (kind == 3) return {maker.rng.in_cube(1), maker.rng.in_cube(1), maker.rng.in_cube(1)};
    std::vector<Vec3d> polygon = Maker::prism(3 + static_cast<int>(maker.rng.below(8)), 0);
    polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
    return polygon;
}

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
    return at_some_gap(maker, std::move(a), std::move(b), -30, 1);
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
    Pair pair = at_some_gap(maker, std::move(a), std::move(b), -20, 1);
    scale(pair.a, factor);
    scale(pair.b, factor);
    for (auto& [pose_a, pose_b] : pair.poses) {
        pose_a.translation *= factor;
        pose_b.translation *= factor;
    }
    return pair;
}

/// Adds offsets to the translations, to the vertices, or to both so that they cancel. They are powers of two,
/// so that the bodies lose few digits.
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

Pair duplicates(Maker& maker) {
    CaseBody a{"a", maker.any_solid(), {}};
    CaseBody b{"b", maker.rng.below(3) == 0 ? a.vertices : maker.any_solid(), {}};
    const auto originals = a.vertices;
    const int copies = maker.pick({1, 2, 9});
    const double beside = maker.pick({0.0, 0x1p-53, 1e-12, 2e-3});
    for (const Vec3d& v : originals) {
        for (int k = 0; k < copies; ++k) a.vertices.push_back(v + maker.rng.in_cube(1) * beside);
    }
    if (maker.rng.below(4) == 0) {  // a body on itself, or a rounding step away
        const Mat3d common = maker.rng.rotation();
        const Vec3d step = maker.rng.on_sphere() * maker.pick({0.0, 0x1p-52});
        return at(a, a, common, common, step);
    }
    return at_some_gap(maker, std::move(a), std::move(b), -30, 1);
}

Pair near_coplanar_vertices(Maker& maker) {
    CaseBody a = maker.rng.below(2) == 0 ? split_cube() : studded_cube(maker);
    if (maker.rng.below(3) == 0) {
        a = {"a", Maker::prism(3 + static_cast<int>(maker.rng.below(62)), 0.5), {}};
    }
    CaseBody b{"b", maker.rng.below(2) == 0 ? Maker::box(0.5, 0.5, 0.5) : maker.any_solid(), {}};
    if (maker.rng.below(2) == 0) return at_some_gap(maker, std::move(a), std::move(b), -30, 1);
    const double gap = maker.either_sign(maker.spread(-30, 0));
    const Mat3d common = maker.common_rotation();
    return at_gap(maker, std::move(a), std::move(b), common, multiply(common, maker.quarter_turn()), gap);
}

Pair flat_bodies(Maker& maker) {
    CaseBody a{"a", flat_points(maker), {}};
    CaseBody b{"b", maker.rng.below(2) == 0 ? flat_points(maker) : maker.any_solid(), {}};
    if (maker.rng.below(4) == 0) {  // in one plane
        for (Vec3d& v : a.vertices) v.z() = 0;
        if (b.vertices.size() < 4) {
            for (Vec3d& v : b.vertices) v.z() = 0;
        }
        const Mat3d common = maker.common_rotation();
        const Vec3d place(maker.pick({0.0, 0.5, 1.0, 2.5}), maker.pick({0.0, 0.25}), 0);
        return at(std::move(a), std::move(b), common, common, multiply(common, place));
    }
    return at_some_gap(maker, std::move(a), std::move(b), -30, 1);
}

Pair thin_beams(Maker& maker) {
    const auto beam = [&] {
        const double thick = maker.rng.uniform(0.08, 0.15);
        std::vector<Vec3d> points = Maker::box(maker.rng.uniform(1, 1.6), thick, thick);
        const Vec3d off = maker.rng.on_sphere() * maker.pick({0.0, 2.0, 6.0});
        const double size = maker.pick({100.0, 1.0, 0.25});
        for (Vec3d& v : points) v = (v + off) * size;
        return points;
    };
    CaseBody a{"a", beam(), {}}, b{"b", beam(), {}};
    return at_some_gap(maker, std::move(a), std::move(b), -20, 0);
}

Pair random_fuzz(Maker& maker) {
    const auto body = [&]() -> std::vector<Vec3d> {
        const double thin = maker.spread(-7, -2);
        const auto kind = maker.rng.below(5);
        if (kind == 0) return Maker::box(1, 1, 1);
        if (kind == 1) return Maker::box(1, 1, thin);
        if (kind == 2) return Maker::box(1, thin, thin);
        return maker.random_points(8 + maker.rng.below(25), Vec3d(1, kind == 3 ? thin : 1, 1));
    };
    CaseBody a{"a", body(), {}}, b{"b", body(), {}};
    const Pose pose_a{maker.rng.rotation(), maker.rng.in_cube(1.15)};
    const Pose pose_b{maker.rng.rotation(), maker.rng.in_cube(1.15)};
    return {std::move(a), std::move(b), {{pose_a, pose_b}}};
}

/// A pair of the available bodies. Without any body there is no pair (the caller reports it).
Pair real_hulls_at_gaps(Maker& maker) {
    const auto real = maker.real();
    const auto some = [&](const char* name) {
        return CaseBody{name, real[maker.rng.below(real.size())].vertices, {}};
    };
    CaseBody a = some("a"), b = some("b");
    const double gap =
        maker.pick({5.0, 1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-8, 1e-12, -1e-12, -1e-8, -1e-4, -1e-3, -0.01, -0.1});
    const double size = reach(a.vertices, Vec3d::Zero());
    return at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap * size);
}

}  // namespace edgewise::scene::hard
