// SPDX-License-Identifier: MIT
//
// Raw V-Clip on cubes side by side, from far apart to as near as rounding: it never asks GJK, and it is the
// hardened one wherever that doubts nothing. On bodies that are not strictly convex some of its answers are
// wrong: the proof by the neighbours of its features accepts no wrong answer, and a fair share of the others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/vec.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/scene/hard/families.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

/// From features that are not a cold pair's, which the hardened walk leaves for nearer ones.
Distance ask_cubes(const ReferenceTable& cube, const Transform<double>& pose, bool hardened) {
    const auto last = Feature<ReferenceTable>::of_vertex(7), first = Feature<ReferenceTable>::of_vertex(0);
    FeaturePair<ReferenceTable, ReferenceTable> pair(cube, cube, {last, first});
    return VClip::query(cube, cube, pose, pair, {.hardened = hardened});
}

TEST(RawWalk, NeverAsksGjkAndIsElseTheHardenedOne) {
    const Polyhedron body = *scene::make_shape("cube8");
    const ReferenceTable cube(body);
    scene::Rng rng(7);
    int doubted = 0, alike = 0;
    for (int i = 0; i < 400; ++i) {
        const double gap = std::pow(10.0, -16 * rng.uniform());
        const double along = 2 * max_abs(body.vertices[0]) + gap;
        const Transform<double> pose{Mat3d::Identity(), {along, 0.3 * rng.uniform(), 0.3 * rng.uniform()}};
        const Distance hardened = ask_cubes(cube, pose, true), raw = ask_cubes(cube, pose, false);
        EXPECT_EQ(raw.fallbacks + raw.refinements, 0);
        EXPECT_EQ(raw.steps, hardened.steps);
        EXPECT_EQ(raw.cycles, hardened.cycles);
        if (hardened.fallbacks + hardened.refinements > 0) {
            ++doubted;
        } else if (gap > 1e-6) {  // and too far for rounding to take it for contact
            ++alike;
            EXPECT_EQ(raw.status, hardened.status);
            EXPECT_EQ(raw.distance, hardened.distance);
            EXPECT_EQ(raw.normal, hardened.normal);
        }
    }
    std::printf("%d doubted, %d alike\n", doubted, alike);
    EXPECT_GT(doubted, 20);
    EXPECT_GT(alike, 100);
}

/// A pyramid on its tip; its base is a grid of squares that turn by 2 * fold from one to the next.
Polyhedron domed(double fold) {
    std::vector<Vec3d> points = {{0, 0, -2}};
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y) points.emplace_back(x, y, -fold * (x * x + y * y));
    return convex_hull(points).or_throw();
}

/// Poses of a lattice: corners lie over sides, where regions of no thickness meet them.
Pose lattice_pose(scene::hard::Maker& maker) {
    Pose pose;
    pose.rotation = maker.quarter_turn();
    for (double& offset : pose.translation) offset = 0.5 * (static_cast<double>(maker.rng.below(25)) - 12);
    return pose;
}

/// Raw answers, and those that the neighbours of both features prove.
struct Ends {
    int separated = 0, wrong = 0, proven = 0;
    int cycles_at_faces = 0;  ///< that end at an edge and a face: no answer
    double worst = 0;         ///< error of a proven distance
};

template <class Table>
Ends ends_of(const Polyhedron& body, double allowed) {
    Ends ends;
    scene::hard::Maker maker(9, false, {});
    scene::Rng& rng = maker.rng;
    const Table table(body, Parts::features);
    EXPECT_FALSE(table.strictly_convex());
    EXPECT_TRUE(table.climbable());
    std::vector<Feature<Table>> edges;
    for (const auto v : table.all_vertices())
        for (const auto [edge, flipped] : table.ring_of_vertex(v))
            edges.push_back(Feature<Table>::of_edge(edge));
    for (int i = 0; i < 20000; ++i) {
        const Pose pose = lattice_pose(maker);
        const Transform<double> a_from_b{pose.rotation, pose.translation};
        FeaturePair<Table, Table> pair(table, table,
                                       {edges[rng.below(edges.size())], edges[rng.below(edges.size())]});
        const Distance raw = VClip::query(table, table, a_from_b, pair, {.hardened = false});
        ends.cycles_at_faces += raw.status == Status::failed;
        if (raw.status != Status::separated || raw.cycles > 0) continue;
        const auto exact = truth::exact_distance(body.vertices, Pose{}, body.vertices, pose).or_throw();
        const double error = std::abs(raw.distance - exact.distance);
        ++ends.separated;
        ends.wrong += error > allowed;
        const auto into_a = cast<ComputeOf<Table>>(a_from_b), into_b = into_a.inverse();
        const auto end = pair.start(table, table);
        const vclip::Body<Table> a{table, into_a, end.a}, b{table, into_b, end.b};
        if (!vclip::both_end_here(raw, vclip::pair_size(a, b), a, b)) continue;
        ++ends.proven;
        ends.worst = std::max(ends.worst, error);
    }
    return ends;
}

/// `share`: least share of proven answers. Coordinates reach 12.
template <class Table>
Ends expect_no_wrong_one_is_proven(double fold, double share, double allowed) {
    const Ends ends = ends_of<Table>(domed(fold), allowed);
    std::printf("%d separated, %d wrong; %d proven, worst error %.3g; %d cycles at faces\n", ends.separated,
                ends.wrong, ends.proven, ends.worst, ends.cycles_at_faces);
    EXPECT_GT(ends.wrong, 20) << "else the test would show nothing";
    EXPECT_GT(ends.proven, share * ends.separated);
    EXPECT_LE(ends.worst, allowed);
    return ends;
}

TEST(RawWalk, NoWrongAnswerIsProvenByNeighbours) {
    (void)expect_no_wrong_one_is_proven<aos<f64>>(1e-10, 0.5, 5e-15);
    const Ends in_single = expect_no_wrong_one_is_proven<aos<f32>>(1e-9, 0.2, 1e-6);
    EXPECT_GT(in_single.cycles_at_faces, 0) << "else nothing shows that they end";
}

}  // namespace
}  // namespace edgewise
