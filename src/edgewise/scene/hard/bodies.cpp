// SPDX-License-Identifier: MIT
//
// Families 11 to 13 and 21 to 23: what bodies users hand in.
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/scene/kinds/scene_setup.hpp"

namespace edgewise::scene::hard {

namespace {

Pair at_some_gap(Maker& maker, CaseBody a, CaseBody b, int finest, int coarsest) {
    const double gap = (maker.rng.below(3) == 0 ? -1 : 1) * maker.spread(finest, coarsest);
    return at_gap(maker, std::move(a), std::move(b), maker.rng.rotation(), maker.rng.rotation(), gap);
}

/// A cube whose sides are given as two triangles each.
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

}  // namespace

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
