// SPDX-License-Identifier: MIT
//
// How often V-Clip leaves a local minimum under a face: once where it must, never where all is plain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

using Pair = FeaturePair<ReferenceTable, ReferenceTable>;

Transform<double> shifted(double x) { return {Mat3d::Identity(), {x, 0, 0}}; }

/// The face that looks along +x.
Index face_ahead(const Polyhedron& body) {
    const auto found = std::find_if(body.face_planes.begin(), body.face_planes.end(),
                                    [](const Plane<double>& plane) { return plane.normal.x() > 0.5; });
    return static_cast<Index>(found - body.face_planes.begin());
}

/// The corner of A points at the back of the cube; the run starts at the cube's far face, and the corner
/// lies under that face's plane; no edge of A leads up to it.
TEST(Escapes, AVertexBehindTheBodyLeavesTheFaceItIsUnder) {
    const std::vector<Vec3d> corner = {{0, 0, 0}, {-1, 1, 0}, {-1, -1, 1}, {-1, -1, -1}};
    const Polyhedron a = *convex_hull(corner), b = *scene::make_shape("cube8");
    const ReferenceTable table_a(a), table_b(b);
    const auto tip = std::find(a.vertices.begin(), a.vertices.end(), corner[0]) - a.vertices.begin();
    Pair pair(table_a, table_b,
              {Feature<ReferenceTable>::of_vertex(static_cast<Index>(tip)),
               Feature<ReferenceTable>::of_face(face_ahead(b))});
    const Distance answer = VClip::query(table_a, table_b, shifted(2), pair);
    EXPECT_EQ(answer.escapes, 1);
    EXPECT_EQ(answer.steps, 2);
    EXPECT_EQ(answer.status, Status::separated);
    EXPECT_EQ(answer.distance, 2 - 0.5625);
    const Distance again = VClip::query(table_a, table_b, shifted(2), pair);
    EXPECT_EQ(again.escapes, 0) << "from where the first run ended";
    EXPECT_EQ(again.distance, answer.distance);
}

/// Tetrahedra in each other, each run from where the last one ended: now and then under a face.
TEST(Escapes, AreCountedInPenetration) {
    const Polyhedron body = *scene::make_shape("tetra4");
    const ReferenceTable table(body);
    Pair pair(table, table);
    scene::Rng rng(5);
    int overlaps = 0, with = 0;
    for (int i = 0; i < 2000; ++i) {
        const Transform<double> pose{rng.rotation(), 0.5 * rng.on_sphere()};
        const Distance answer = VClip::query(table, table, pose, pair);
        EXPECT_LT(answer.escapes, answer.steps);
        overlaps += answer.status == Status::overlapping;
        with += answer.status == Status::overlapping && answer.escapes > 0;
    }
    std::printf("escapes: on the way to %d of %d overlaps\n", with, overlaps);
    EXPECT_GT(with, 0);
    EXPECT_LT(with, overlaps / 10);
}

}  // namespace
}  // namespace edgewise
