// SPDX-License-Identifier: MIT
//
// The generic answers to ring questions compared with a search over single planes, ties included; and that a
// table's own answer is preferred. Every layout is asked the same in its contract test.
#include "edgewise/table/ring_questions.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

struct Worst {
    std::optional<Index> edge;
    double violation = 0;
    int ties = 0;  ///< later entries that are just as bad
};

template <class Ring, class DistanceOf>
Worst worst_of(const Ring& ring, DistanceOf distance_of) {
    Worst worst;
    for (const auto entry : ring) {
        const double d = distance_of(entry);
        if (d >= 0) continue;
        if (worst.edge && -d == worst.violation) ++worst.ties;
        if (!worst.edge || -d > worst.violation) worst = {entry.edge, -d, 0};
    }
    return worst;
}

TEST(RingQuestions, FindTheMostViolatedPlaneAndTheFirstOfEquals) {
    scene::Rng rng(1);
    int inside = 0, ties = 0;
    for (const char* shape : {"tetra4", "cube8", "sphere38"}) {
        const auto body = scene::make_shape(shape);
        ASSERT_TRUE(body) << body.error;
        const ReferenceTable table(*body);
        for (int i = 0; i < 3000; ++i) {
            Vec3d point = rng.in_cube(3);
            if (i % 2) point = (point * 2).array().round() / 2;  // on a lattice: ties
            const auto v = static_cast<Index>(rng.below(body->vertex_count()));
            const auto f = static_cast<Index>(rng.below(body->face_count()));
            const Worst around = worst_of(table.ring_of_vertex(v), [&](RingEdge<Index> r) {
                return table.vertex_edge_plane(r.edge, r.flipped ? End::head : End::tail).distance(point);
            });
            const Worst about = worst_of(table.ring_of_face(f), [&](RingEdge<Index> r) {
                return table.edge_face_plane(r.edge, r.flipped ? Side::right : Side::left).distance(point);
            });
            EXPECT_EQ(most_violated_vertex_plane(table, v, point), around.edge);
            EXPECT_EQ(most_violated_face_side(table, f, point), about.edge);
            inside += !around.edge + !about.edge;
            ties += (around.ties > 0) + (about.ties > 0);
        }
    }
    EXPECT_GT(inside, 500);
    EXPECT_GT(ties, 200);
}

TEST(RingQuestions, SteepestDescentIsTheLeastSlopeAndTheFirstOfEquals) {
    scene::Rng rng(2);
    int none = 0, ties = 0;
    for (const char* shape : {"tetra4", "cube8", "sphere38"}) {
        const auto body = scene::make_shape(shape);
        ASSERT_TRUE(body) << body.error;
        const ReferenceTable table(*body);
        for (int i = 0; i < 3000; ++i) {
            Vec3d normal = rng.on_sphere();
            if (i % 2) normal = (normal * 1.5).array().round();
            const auto v = static_cast<Index>(rng.below(body->vertex_count()));
            const auto leaving = [&](RingEdge<Index> r) {
                return (r.flipped ? -1 : 1) * squared_slope(dot(table.direction(r.edge), normal));
            };
            const Worst steepest = worst_of(table.ring_of_vertex(v), leaving);
            double largest = 0;
            for (const auto r : table.ring_of_vertex(v)) largest = std::max(largest, std::abs(leaving(r)));
            const auto descent = steepest_descent(table, v, normal);
            EXPECT_EQ(descent.edge, steepest.edge);
            EXPECT_EQ(-descent.slope, steepest.violation);
            EXPECT_EQ(descent.steepest, largest);
            none += !descent.edge;
            ties += steepest.ties > 0;
        }
    }
    EXPECT_GT(none, 500);
    EXPECT_GT(ties, 200);
}

/// A table with answers of its own.
struct OwnAnswers : ReferenceTable {
    using ReferenceTable::ReferenceTable;
    [[nodiscard]] std::optional<Index> most_violated_vertex_plane(Index, const Vec3d&) const { return 3; }
    [[nodiscard]] std::optional<Index> most_violated_face_side(Index, const Vec3d&) const { return 4; }
    [[nodiscard]] auto steepest_descent(Index, const Vec3d&) const { return Descent<Edge, double>{5, -1, 2}; }
};

TEST(RingQuestions, ATablesOwnAnswerIsPreferred) {
    const auto body = scene::make_shape("cube8");
    ASSERT_TRUE(body) << body.error;
    const OwnAnswers table(*body);
    EXPECT_EQ(most_violated_vertex_plane(table, 0, Vec3d::Zero()), 3U);
    EXPECT_EQ(most_violated_face_side(table, 0, Vec3d::Zero()), 4U);
    EXPECT_EQ(steepest_descent(table, 0, Vec3d::Zero()).edge, 5U);
}

}  // namespace
}  // namespace edgewise
