// SPDX-License-Identifier: MIT
//
// The layouts of engines compared with what is published of them: bytes per edge from their lists of fields,
// bodies that they refuse, and numbers that are stored twice or are found by a scan.
#include <gtest/gtest.h>

#include <vector>

#include "cones.hpp"
#include "edgewise/algorithms/support.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layouts/box3d.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/lean_seeds.hpp"
#include "edgewise/layouts/mujoco.hpp"
#include "edgewise/layouts/parry.hpp"
#include "edgewise/layouts/physx.hpp"
#include "edgewise/layouts/swift.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"
#include "expect_rings.hpp"
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
    // The engine's object of 48 bytes next to the arrays makes these 11.5 and 36.5.
    EXPECT_NEAR(bytes_per_edge<physx<f32>>(testing::round_body(255), -48), 11.5, 0.05);
    EXPECT_NEAR(bytes_per_edge<physx<f32>>(shape("sphere38"), -48), 36.5, 0.05);
    EXPECT_NEAR(bytes_per_edge<physx<f32>>(testing::round_body(255)), 11.42, 0.01);
    // Bodies that box3d takes are far from the limit of V / E = 1/3 and F / E = 2/3.
    const double per_vertex = 25, per_edge = 8, per_face = 29, e = 108;
    EXPECT_NEAR(bytes_per_edge<box3d<f32>>(shape("sphere38")),
                (per_vertex * 38 + per_edge * e + per_face * 72) / e, 1e-9);
    EXPECT_NEAR(per_vertex / 3 + per_edge + per_face * 2 / 3, 35.7, 0.05);
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

/// Checks the rings of the bodies that the layout takes; `count`: their expected number.
template <class Table>
void expect_rings_of(std::size_t count, const std::vector<Polyhedron>& bodies) {
    std::size_t taken = 0;
    for (const Polyhedron& given : bodies) {
        const auto body = stored_body<Table>(given);
        if (!body) continue;
        testing::expect_rings(Table(*body, Parts::features), *body);
        ++taken;
    }
    EXPECT_EQ(taken, count) << Table::name;
}

TEST(EngineLayouts, KeepRingsOfEveryLength) {
    std::vector<Polyhedron> bodies = {testing::double_cone(3),  testing::double_cone(9),
                                      testing::double_cone(40), shape("cube8"),
                                      shape("uv_sphere386"),    testing::round_body(255)};
    bodies.push_back(hull_of_any(std::vector<Vec3d>{{0.5, 0, 0}}).or_throw());
    bodies.push_back(hull_of_any(std::vector<Vec3d>{{0.5, 0, 0}, {1, 0, 0}}).or_throw());
    expect_rings_of<physx<f32>>(7, bodies);
    expect_rings_of<box3d<f32>>(6, bodies);
    expect_rings_of<parry<f32>>(8, bodies);
    expect_rings_of<swift<f64>>(8, bodies);
    expect_rings_of<mujoco<mixed>>(8, bodies);
}

TEST(EngineLayouts, Box3dScansAsOthersDo) {
    scene::Rng rng(8);
    for (const Polyhedron& given : {shape("cube8"), shape("sphere38"), testing::double_cone(13)}) {
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
