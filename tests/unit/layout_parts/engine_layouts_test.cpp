// SPDX-License-Identifier: MIT
//
// The layouts of engines beside what is published of them: bytes per edge from their lists of fields, bodies
// that they refuse, and numbers that stand there twice or are found by a scan.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/box3d.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/lean_seeds1536.hpp"
#include "edgewise/layouts/mujoco.hpp"
#include "edgewise/layouts/parry.hpp"
#include "edgewise/layouts/physx.hpp"
#include "edgewise/layouts/swift.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"
#include "round_body.hpp"

namespace edgewise {
namespace {

template <class Table>
Polyhedron held(const Polyhedron& given) {
    return stored_body<Table>(given).or_throw();
}
Polyhedron shape(const char* name) { return scene::make_shape(name).or_throw(); }

/// Without `constant`, and without padding unless records have it.
template <class Table>
double bytes_per_edge(const Polyhedron& given, double constant = 0, bool with_padding = false) {
    const Polyhedron body = held<Table>(given);
    const Ledger ledger = Table(body, Parts::features).ledger();
    const std::size_t bytes = ledger.total() - (with_padding ? 0 : ledger[Component::padding]);
    return (static_cast<double>(bytes) - constant) / static_cast<double>(body.edge_count());
}

/// V vertices, E = 3 V - 6 edges and F = 2 V - 4 faces; published figures are for many vertices, or say for
/// how many.
TEST(EngineLayouts, TakeTheBytesThatArePublished) {
    // The engine's object of 48 bytes beside the arrays makes these 11.5 and 36.5.
    EXPECT_NEAR(bytes_per_edge<physx<f32>>(testing::round_body(255), -48), 11.5, 0.05);
    EXPECT_NEAR(bytes_per_edge<physx<f32>>(shape("sphere38"), -48), 36.5, 0.05);
    EXPECT_NEAR(bytes_per_edge<physx<f32>>(testing::round_body(255)), 11.42, 0.01);
    const auto in_the_limit = [](double per_vertex, double per_edge, double per_face) {
        return per_vertex / 3 + per_edge + per_face * 2 / 3;
    };
    EXPECT_NEAR(in_the_limit(25, 8, 29), 35.7, 0.05) << "box3d";
    const Polyhedron ball = shape("sphere38");
    const double v = 38, e = 108, f = 72;
    EXPECT_NEAR(bytes_per_edge<box3d<f32>>(ball), (25 * v + 8 * e + 29 * f) / e, 1e-9);
    // An edge ends with a flag of one byte: the rest of its record is padding, and so are ends of arrays.
    EXPECT_NEAR(bytes_per_edge<parry<f32>>(shape("sphere6146"), 0, true), 84, 0.04);
    EXPECT_NEAR(bytes_per_edge<parry<f64>>(shape("sphere6146"), 0, true), 112, 0.04);
    EXPECT_NEAR(bytes_per_edge<swift<f64>>(shape("sphere6146")), 245.3, 0.05);
    EXPECT_NEAR(bytes_per_edge<mujoco<mixed>>(shape("sphere218"), 108), 24.1, 0.05);
    EXPECT_NEAR(bytes_per_edge<mujoco<mixed>>(shape("sphere386"), 108), 24 + 56 / 1152.0, 1e-9);
}

TEST(EngineLayouts, RefuseWhatTheirIndicesCannotCount) {
    EXPECT_TRUE(stored_body<physx<f32>>(testing::round_body(255)));
    EXPECT_EQ(stored_body<physx<f32>>(testing::round_body(256)).error,
              "physx takes bodies of up to 255 vertices, and this one has 256");
    EXPECT_TRUE(stored_body<box3d<f32>>(testing::round_body(44)));  // 126 edges
    EXPECT_EQ(stored_body<box3d<f32>>(testing::round_body(45)).error,
              "box3d takes bodies of up to 128 edges, and this one has 129");
}

/// Two tops over and under a polygon.
Polyhedron double_cone(int sides) {
    std::vector<Vec3d> points = {{0, 0, 1}, {0.1, 0, -1}};
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        points.push_back({std::cos(angle), std::sin(angle), 0});
    }
    return convex_hull(points).or_throw();
}

template <class Table>
void expect_rings(const Polyhedron& given) {
    if (!stored_body<Table>(given)) return;
    const Polyhedron body = held<Table>(given);
    const Table table(body, Parts::features);
    for (Index v = 0; v < body.vertex_count(); ++v) {
        std::vector<Index> found, expected;
        for (const Index w : table.neighbours(v)) found.push_back(w);
        for (const HalfEdge h : body.ring_of_vertex(v)) expected.push_back(body.head(h));
        EXPECT_EQ(found, expected) << Table::name << " vertex " << v << " of " << body.vertex_count();
    }
}

TEST(EngineLayouts, KeepRingsOfEveryLength) {
    std::vector<Polyhedron> bodies = {double_cone(3), double_cone(9),        double_cone(40),
                                      shape("cube8"), shape("uv_sphere386"), testing::round_body(255)};
    bodies.push_back(hull_of_any(std::vector<Vec3d>{{0.5, 0, 0}}).or_throw());
    bodies.push_back(hull_of_any(std::vector<Vec3d>{{0.5, 0, 0}, {1, 0, 0}}).or_throw());
    for (const Polyhedron& body : bodies) {
        expect_rings<physx<f32>>(body);
        expect_rings<box3d<f32>>(body);
        expect_rings<parry<f32>>(body);
        expect_rings<swift<f64>>(body);
        expect_rings<mujoco<mixed>>(body);
    }
}

TEST(EngineLayouts, Box3dScansAsOthersDo) {
    scene::Rng rng(8);
    for (const Polyhedron& given : {shape("cube8"), shape("sphere38"), double_cone(13)}) {
        const Polyhedron body = held<box3d<f32>>(given);
        const box3d<f32> table(body, Parts::support);
        const lean<f32> plain(body, Parts::support);
        for (int i = 0; i < 500; ++i) {
            Vec3d wanted = rng.on_sphere();
            if (i % 3 == 0) wanted = (wanted * 1.5).array().round();  // lattice: equal vertices
            const auto direction = cast<float>(wanted);
            const auto found = scan_support(table, direction);
            const auto expected = scan_support(plain, direction);
            EXPECT_EQ(found.vertex, expected.vertex);
            EXPECT_EQ(found.along, expected.along);
        }
    }
}

TEST(EngineLayouts, PhysxAndMujocoBeginWhereTheirTablesSay) {
    const Polyhedron body = held<physx<f32>>(shape("sphere218"));
    const physx<f32> table(body, Parts::support);
    const lean_seeds1536<f32> like(body, Parts::support);
    const mujoco<mixed> graph(body, Parts::support);
    scene::Rng rng(3);
    for (int i = 0; i < 500; ++i) {
        const Vec3d direction = rng.on_sphere();
        EXPECT_EQ(table.seed(cast<float>(direction)), like.seed(cast<float>(direction)));
        const Vec3d corner = CornerDirections::direction(CornerDirections::place(direction));
        EXPECT_EQ(graph.seed(direction), farthest_vertex(body, corner));
    }
}

}  // namespace
}  // namespace edgewise
