// SPDX-License-Identifier: MIT
//
// The proof that two features are closest, of every pair of features of bodies in random poses, beside exact
// arithmetic: whatever it proves must be the distance, and of separated bodies it must prove some pair,
// unless two vertices are closest.
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
    int separated = 0, proven = 0, overlapping = 0;
};

template <class Table>
void prove_all(const Table& table, const Polyhedron& body, const Pose& pose, Proofs& proofs) {
    const auto exact = truth::exact_distance(body.vertices, Pose{}, body.vertices, pose).or_throw();
    const bool is_separated = exact.distance > 0;
    const auto into_a = cast<ComputeOf<Table>>(Transform<double>{pose.rotation, pose.translation});
    const auto into_b = into_a.inverse();
    const auto features = features_of(table);
    int found = 0;
    for (const auto& of_a : features) {
        for (const auto& of_b : features) {
            const vclip::Body<Table> a{table, into_a, of_a}, b{table, into_b, of_b};
            const auto points = vclip::still_closest(a, b);
            if (!points) continue;
            ++found;
            ++proofs.of_kinds[vclip::pair_of(of_a.kind(), of_b.kind())];
            const double distance = norm(cast<double>(Vec3<ComputeOf<Table>>(points->on_b - points->on_a)));
            proofs.worst = std::max(proofs.worst, std::abs(distance - exact.distance));
        }
    }
    EXPECT_TRUE(is_separated || found == 0);
    (is_separated ? proofs.separated : proofs.overlapping) += 1;
    proofs.proven += found > 0;
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
        for (int i = 0; i < 150; ++i) prove_all(table, body, some_pose(rng, table.reach()), proofs);
    }
    return proofs;
}

void expect_proofs(const Proofs& proofs, double most_error) {
    std::printf("%d of %d separated poses proven, worst error %.3g; %d overlapping ones; proofs by kinds",
                proofs.proven, proofs.separated, proofs.worst, proofs.overlapping);
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
    EXPECT_GT(proofs.proven, proofs.separated * 9 / 10) << "but for pairs of vertices";
    EXPECT_LT(proofs.worst, most_error);
}

TEST(StillClosest, ProvesTheExactDistanceOfAlmostAllSeparatedPoses) {
    expect_proofs(proofs_of<lean<f64>>({"tetra4", "cube8", "sphere38"}), 1e-14);
}

TEST(StillClosest, InSingleToo) { expect_proofs(proofs_of<lean<f32>>({"tetra4", "sphere38"}), 1e-5); }

TEST(StillClosest, ProvesNothingOfBodiesWhoseNeighboursDoNotDecide) {
    // A corner as good as in the middle of a side; and thin corners of a body that is strictly convex.
    for (const double aside : {1e-9, 0.01}) {
        const std::vector<Vec3d> needle = {{0, 0, 0}, {1, 0, 0}, {0.5, aside, 0}, {0.5, 0, 1}};
        const Polyhedron body = convex_hull(needle).or_throw();
        const lean<f64> table(body, Parts::features);
        EXPECT_EQ(table.strictly_convex(), aside == 0.01);
        EXPECT_FALSE(table.neighbours_decide());
        Proofs proofs;
        scene::Rng rng(7);
        for (int i = 0; i < 50; ++i) prove_all(table, body, some_pose(rng, 1), proofs);
        EXPECT_EQ(proofs.proven, 0);
        EXPECT_GT(proofs.separated, 5);
    }
}

}  // namespace
}  // namespace edgewise
