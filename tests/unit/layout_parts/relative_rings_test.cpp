// SPDX-License-Identifier: MIT
//
// Neighbours as differences: the same rings as plain indices give, in whatever order the body comes, with
// entries that do not fit a byte; the bytes of either form; and the user's indices.
//
// Numbers of half-edges where a vertex has more neighbours than its part of the number can count, and widths
// of a narrow table's indices at their limits.
#include "edgewise/layout_parts/relative_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <vector>

#include "cones.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/vertex_order.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/lean_relative.hpp"
#include "edgewise/layouts/quantised_relative.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"
#include "expect_rings.hpp"
#include "round_body.hpp"

namespace edgewise {
namespace {

/// A round body with a thorn that all of a cap sees: a vertex of many neighbours among others of few.
Polyhedron thorn(std::size_t vertices, double height) {
    std::vector<Vec3d> points = testing::round_body(vertices).vertices;
    points.push_back({0, 0, height});
    return convex_hull(points).or_throw();
}

std::size_t far_entries(const Polyhedron& body) {
    std::size_t far = 0;
    for (const HalfEdge h : body.vertex_ring)
        far += fits_a_byte(difference(body.tail(h), body.head(h))) ? 0 : 1;
    return far;
}

/// Topology of a table of this body with entries of a byte, and with plain ones.
std::size_t relative_bytes(const Polyhedron& body) {
    const std::size_t entries = body.vertex_ring.size(), offset = narrow_width(entries);
    return offset * (body.vertex_count() + 1) + entries +
           far_entries(body) * (offset + narrow_width(body.vertex_count() - 1));
}

TEST(RelativeRings, AreThoseOfTheBodyInAnyOrder) {
    std::vector<Polyhedron> bodies = {testing::pyramid(300), testing::pyramid(3000), thorn(2000, 1.05),
                                      thorn(700, 3)};
    for (const char* shape : {"tetra4", "cube8", "sphere386", "uv_sphere386", "sphere6146"})
        bodies.push_back(scene::make_shape(shape).or_throw());
    std::size_t met[2] = {0, 0};  // entries that fit in tables of bytes, and that do not
    for (const Polyhedron& given : bodies) {
        for (const VertexOrder order : {VertexOrder::given, VertexOrder::spatial, VertexOrder::rcm}) {
            const Polyhedron body = reordered(given, order).or_throw();
            const lean_relative<f64> table(body, Parts::features);
            testing::expect_rings(table, body);
            const std::size_t relative = relative_bytes(body);
            const std::size_t plain = lean<f64>(body, Parts::features).ledger()[Component::topology];
            EXPECT_EQ(table.ledger()[Component::topology], std::min(relative, plain));
            if (relative >= plain) continue;
            met[1] += far_entries(body);
            met[0] += body.vertex_ring.size() - far_entries(body);
        }
    }
    std::printf("%zu entries of a byte, %zu beyond it\n", met[0], met[1]);
    EXPECT_GT(met[0], 10000U);
    EXPECT_GT(met[1], 100U);
}

/// 24, 12 or 6 bytes per vertex; two bytes of ring offsets; a byte for each of two neighbours per edge.
TEST(RelativeRings, TakeAByteUpToThreeThousandEightHundredVertices) {
    for (const char* shape : {"sphere386", "sphere1538", "sphere3846"}) {
        const Polyhedron given = scene::make_shape(shape).or_throw();
        const Polyhedron single = stored_body<lean_relative<f32>>(given).or_throw();
        const Polyhedron on_grid = stored_body<quantised_relative<f64>>(given).or_throw();
        const Polyhedron body = stored_body<lean_relative<f64>>(given).or_throw();
        EXPECT_LE(bandwidth(body), 127U);
        EXPECT_EQ(relative_bytes(body), 2 * (body.vertex_count() + 1) + 2 * body.edge_count());
        const auto per_edge = [&](const auto& table) {
            return static_cast<double>(table.ledger().total()) / static_cast<double>(body.edge_count());
        };
        EXPECT_NEAR(per_edge(lean_relative<f64>(body, Parts::features)), 10.67, 0.1);
        EXPECT_NEAR(per_edge(lean_relative<f32>(single, Parts::features)), 6.67, 0.1);
        EXPECT_NEAR(per_edge(quantised_relative<f64>(on_grid, Parts::features)), 4.67, 0.1);
    }
}

TEST(RelativeRings, KeepTheUsersIndicesWhereAsked) {
    for (const char* shape : {"cube8", "sphere38", "sphere386"}) {
        const Polyhedron given = scene::make_shape(shape).or_throw();
        const Polyhedron body = stored_body<lean_relative<f64>>(given).or_throw();
        const lean_relative<f64> without(body, Parts::features);
        const lean_relative<f64> table(body, Parts::features, {}, InputOrder::kept);
        EXPECT_FALSE(without.keeps_input_order());
        EXPECT_EQ(without.ledger()[Component::input_order], 0U);
        ASSERT_TRUE(table.keeps_input_order());
        EXPECT_EQ(table.ledger()[Component::input_order],
                  narrow_width(body.vertex_count() - 1) * body.vertex_count());
        std::size_t moved = 0;
        for (Index v = 0; v < body.vertex_count(); ++v) {
            EXPECT_EQ(table.input_index(v), body.input_index[v]);
            EXPECT_EQ(given.vertices[table.input_index(v)], table.vertex(v));
            moved += table.input_index(v) != v;
        }
        EXPECT_GT(moved, 0U) << shape;
        testing::expect_rings(table, body);
    }
}

TEST(DerivedRings, NumbersEdgesOfATipWithManyNeighbours) {
    constexpr int sides = 3000;
    const Polyhedron body = testing::pyramid(sides);
    ASSERT_EQ(body.vertex_count(), sides + 1U);
    const lean<f64> table(body, Parts::features);
    std::set<std::uint32_t> names;
    std::size_t by_place = 0;
    for (const auto v : table.all_vertices()) {
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            const std::uint32_t name = table.edge_name(edge);
            ASSERT_TRUE(names.insert(name).second) << "each half-edge has its own";
            ASSERT_LT(name, 1U << feature_name_bits);
            by_place += name >> (feature_name_bits - 1);
            const auto found = table.edge_named(name);
            ASSERT_TRUE(found.has_value());
            ASSERT_TRUE(*found == edge);
            ASSERT_EQ(found->at, edge.at);
            ASSERT_EQ(found->from_head, edge.from_head);
        }
    }
    EXPECT_EQ(names.size(), 2 * body.edge_count());
    EXPECT_EQ(by_place, sides - 1024U) << "12 bits name the vertex, 10 are left";
    // Any half-edge may be named by its place; of other numbers those that were given, and no more.
    constexpr std::uint32_t flag = 1U << (feature_name_bits - 1);
    for (std::uint32_t name = 0; name < 2 * flag; name += 7) {
        const bool is_known = name < flag ? names.contains(name) : name - flag < 2 * body.edge_count();
        ASSERT_EQ(table.edge_named(name).has_value(), is_known) << name;
    }
}

TEST(DerivedRings, ATableForSupportAloneHasNoFeatures) {
    const lean<f64> table(testing::pyramid(5), Parts::support);
    EXPECT_FALSE(table.edge_named(0).has_value());
    EXPECT_FALSE(table.face_named(0).has_value());
}

TEST(IndexWidth, IndicesWidenAtTheirLimits) {
    for (const auto& [largest, width] : {std::pair{255U, 1U}, {256U, 2U}, {65535U, 2U}, {65536U, 4U}}) {
        std::uint32_t stored_width = 0, at = 0;
        const Block block([&, &largest = largest](BlockPlan& plan) {
            plan.array_at<std::uint32_t>(1, {});
            const NarrowPlace place(plan, 2, largest);
            stored_width = place.width;
            at = place.at;
        });
        EXPECT_EQ(stored_width, width);
        EXPECT_EQ(block.size(), at + 2 * width);
        NarrowArray array(block.base() + at, width);
        array.fill(2, [&, &largest = largest](Index i) { return i == 0 ? largest : 7; });
        EXPECT_EQ(array.read(Direct{}, 0, Field::neighbour), largest);
        EXPECT_EQ(array.read(Direct{}, 1, Field::neighbour), 7U);
    }
}

}  // namespace
}  // namespace edgewise
