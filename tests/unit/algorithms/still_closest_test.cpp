// SPDX-License-Identifier: MIT
//
// The proof that two features are closest, of every pair of features of bodies in random poses, compared with
// exact arithmetic: whatever it proves must be the distance, and of separated bodies it must prove some pair,
// unless two vertices are closest. The proof that an edge pierces a face likewise: only bodies that overlap.
#include "edgewise/algorithms/vclip/still_closest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "folded_pyramid.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

template <class Table>
std::vector<Feature<Table>> features_of(const Table& table) {
    std::vector<Feature<Table>> all;
    for (const auto v : table.all_vertices()) {
        all.push_back(Feature<Table>::of_vertex(v));
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            if (!flipped) all.push_back(Feature<Table>::of_edge(edge));
        }
    }
    for (const auto f : table.all_faces()) all.push_back(Feature<Table>::of_face(f));
    return all;
}

struct Proofs {
    std::array<int, 9> of_kinds = {};  ///< by vclip::pair_of
    double worst = 0;                  ///< error of a proven distance
    double worst_turn = 0;             ///< of a face's normal that goes with one, radians
    int separated = 0, proven = 0, overlapping = 0, pierced = 0;
};

/// Poses of a body at rest and another.
template <class Table>
void prove_all(const Polyhedron& body_a, const Polyhedron& body_b, const Pose& pose, Proofs& proofs) {
    const Table table_a(body_a, Parts::features), table_b(body_b, Parts::features);
    const auto exact = truth::exact_distance(body_a.vertices, Pose{}, body_b.vertices, pose).or_throw();
    const bool is_separated = exact.distance > 0;
    const auto into_a = cast<ComputeOf<Table>>(Transform<double>{pose.rotation, pose.translation});
    const auto into_b = into_a.inverse();
    const auto features_a = features_of(table_a), features_b = features_of(table_b);
    int found = 0, piercing = 0;
    for (const auto& of_a : features_a) {
        for (const auto& of_b : features_b) {
            const vclip::Body<Table> a{table_a, into_a, of_a}, b{table_b, into_b, of_b};
            piercing += vclip::still_pierced(a, b);
            const auto points = vclip::still_closest(a, b);
            if (!points) continue;
            ++found;
            ++proofs.of_kinds[vclip::pair_of(of_a.kind(), of_b.kind())];
            const double distance = norm(cast<double>(Vec3<ComputeOf<Table>>(points->on_b - points->on_a)));
            proofs.worst = std::max(proofs.worst, std::abs(distance - exact.distance));
            if (max_abs(points->normal) == 0) continue;
            const Vec3d between = exact.separation / exact.distance;
            const double turn = norm(Vec3d(cross(cast<double>(points->normal), between)));
            proofs.worst_turn = std::max(proofs.worst_turn, turn);
        }
    }
    EXPECT_TRUE(is_separated ? piercing == 0 : found == 0);
    (is_separated ? proofs.separated : proofs.overlapping) += 1;
    proofs.proven += found > 0;
    proofs.pierced += piercing > 0;
}

/// From deep inside of each other to two sizes from each other.
Pose some_pose(scene::Rng& rng, double size) {
    Pose pose;
    pose.rotation = rng.rotation();
    pose.translation = rng.uniform(0.3, 3) * size * rng.on_sphere();
    return pose;
}

template <class Table>
Proofs proofs_of(std::initializer_list<const char*> shapes) {
    Proofs proofs;
    scene::Rng rng(3);
    for (const char* shape : shapes) {
        Polyhedron body = *scene::make_shape(shape);
        const Table table(body, Parts::features);
        EXPECT_TRUE(table.neighbours_decide()) << shape;
        for (int i = 0; i < 150; ++i) prove_all<Table>(body, body, some_pose(rng, table.reach()), proofs);
    }
    return proofs;
}

void expect_proofs(const Proofs& proofs, double most_error) {
    std::printf(
        "%d of %d separated poses proven, worst error %.3g; %d of %d overlapping ones; proofs by kinds",
        proofs.proven, proofs.separated, proofs.worst, proofs.pierced, proofs.overlapping);
    for (const int count : proofs.of_kinds) std::printf(" %d", count);
    std::printf("\n");
    using enum FeatureKind;
    for (const FeatureKind a : {vertex, edge, face}) {
        for (const FeatureKind b : {vertex, edge, face}) {
            // Two vertices prove themselves; a face and more than a vertex are never closest.
            const bool is_proven = (a == vertex) != (b == vertex) || (a == edge && b == edge);
            EXPECT_EQ(proofs.of_kinds[vclip::pair_of(a, b)] > 0, is_proven);
        }
    }
    EXPECT_GT(proofs.overlapping, 20);
    EXPECT_GT(proofs.pierced, proofs.overlapping * 9 / 10) << "except where a body holds the other";
    EXPECT_GT(proofs.proven, proofs.separated * 9 / 10) << "except for pairs of vertices";
    EXPECT_LT(proofs.worst, most_error);
}

TEST(StillClosest, ProvesTheExactDistanceOfAlmostAllSeparatedPoses) {
    expect_proofs(proofs_of<lean<f64>>({"tetra4", "cube8", "sphere38"}), 1e-14);
}

TEST(StillClosest, InSingleToo) { expect_proofs(proofs_of<lean<f32>>({"tetra4", "sphere38"}), 1e-5); }

TEST(StillClosest, ProvesNothingOfBodiesWhoseNeighboursDoNotDecide) {
    const Polyhedron body = testing::folded_pyramid(0);
    EXPECT_FALSE(lean<f64>(body, Parts::features).neighbours_decide());
    Proofs proofs;
    scene::Rng rng(7);
    for (int i = 0; i < 50; ++i) prove_all<lean<f64>>(body, body, some_pose(rng, 1), proofs);
    EXPECT_EQ(proofs.proven, 0);
    EXPECT_GT(proofs.separated, 5);
}

/// A face with a thin corner: the third lies `aside` of the side between the first two, of length 1; and
/// behind it the body turns away by an angle as small as `turn`, which strictly convex bodies do not.
/// Coordinates are those of `Scalar`.
template <class Scalar>
struct Needle {
    std::vector<Vec3d> corners;
    Vec3d out, within;  ///< unit: across the face; within it, across the side

    Needle(scene::Rng& rng, double aside, double turn) {
        const double middle = rng.uniform(0.3, 0.7), far = rng.uniform(0.3, 1);
        corners = {{0, 0, 0}, {1, 0, 0}, {middle, aside, 0}, {rng.uniform(0.2, 0.8), far, -turn * far}};
        corners.emplace_back(middle, rng.uniform(-0.5, -0.1), rng.uniform(-1, -0.5));
        const Mat3d rotation = rng.rotation();
        for (Vec3d& corner : corners) corner = cast<double>(cast<Scalar>(Vec3d(rotation * corner)));
        const Vec3d across = cross(corners[1], corners[2]);
        out = across / norm(across);
        within = cross(out, corners[1]) / norm(corners[1]);
    }
};

/// Returns a body with its apex at the origin and the other vertices along `out`.
template <class Scalar>
Polyhedron spike(const Needle<Scalar>& on) {
    const Vec3d& along = on.corners[1];
    return convex_hull(std::vector<Vec3d>{{0, 0, 0},
                                          on.out + 0.3 * along,
                                          on.out - 0.2 * along + 0.3 * on.within,
                                          on.out - 0.2 * along - 0.3 * on.within})
        .or_throw();
}

/// Returns a pose with the apex over the side. Its direction is normal to the thin face up to a tilt, which
/// can be as small as a rounding step and decides if the thin corner and the part behind it are higher.
template <class Scalar>
Pose over_side(scene::Rng& rng, const Needle<Scalar>& on) {
    const double tilt = std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.uniform(5, 54)));
    const double distance = std::ldexp(1.0, -static_cast<int>(rng.uniform(0, 12)));
    Pose pose;
    pose.translation = rng.uniform(0.05, 0.95) * on.corners[1] + distance * (on.out + tilt * on.within);
    return pose;
}

/// Expects that some poses are proven and that no distance is wrong by more than `most_error`.
template <class Table>
void expect_certain_on_thin_corners(double thinnest, double most_error) {
    using Scalar = ComputeOf<Table>;
    scene::Rng rng(11);
    Proofs proofs;
    int bodies = 0;
    const auto some_power = [&rng](double least) { return std::pow(10, rng.uniform(std::log10(least), -1)); };
    for (int i = 0; i < 4000; ++i) {
        const Needle<Scalar> thin(rng, some_power(thinnest), some_power(thinnest));
        const Polyhedron body = convex_hull(thin.corners).or_throw();
        if (!Table(body, Parts::features).neighbours_decide()) continue;
        ++bodies;
        prove_all<Table>(body, spike(thin), over_side(rng, thin), proofs);
    }
    std::printf("%d of %d poses on %d bodies proven, worst error %.3g, normals off by %.3g rad\n",
                proofs.proven, proofs.separated, bodies, proofs.worst, proofs.worst_turn);
    EXPECT_GT(proofs.proven, proofs.separated / 8);
    EXPECT_LT(proofs.worst, most_error);
    EXPECT_LT(proofs.worst_turn, 4096 * most_error) << "of two points 2^-12 from each other";
}

TEST(StillClosest, ProvesOfThinCornersWhatIsCertain) {
    expect_certain_on_thin_corners<lean<f64>>(1e-8, 1e-14);
    expect_certain_on_thin_corners<lean<f64>>(1e-13, 1e-14);
}

TEST(StillClosest, ProvesOfThinCornersWhatIsCertainInSingle) {
    expect_certain_on_thin_corners<lean<f32>>(1e-5, 1e-6);
    expect_certain_on_thin_corners<lean<f32>>(1e-9, 1e-6);
}

}  // namespace
}  // namespace edgewise
