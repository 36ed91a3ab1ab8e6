// SPDX-License-Identifier: MIT
//
// Numbers of half-edges where a vertex has more neighbours than its part of the number can count, and widths
// of a narrow table's indices at their limits.
#include <gtest/gtest.h>

#include <set>

#include "cones.hpp"
#include "edgewise/layouts/lean.hpp"
#include "round_body.hpp"

namespace edgewise {
namespace {

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

TEST(IndexWidth, NeighboursOf256VerticesTakeOneByteAndOf257Two) {
    for (const std::size_t count : {256, 257}) {
        const Polyhedron body = testing::round_body(count);
        ASSERT_EQ(body.vertex_count(), count);
        const lean<f64> table(body, Parts::features);
        const std::size_t bytes = count == 256 ? 1 : 2;
        EXPECT_EQ(table.ledger()[Component::topology],
                  2 * (body.vertex_count() + 1) + bytes * 2 * body.edge_count());
        for (Index v = 0; v < body.vertex_count(); ++v) {
            std::size_t at = 0;
            for (const Index w : table.neighbours(v)) EXPECT_EQ(w, body.head(body.ring_of_vertex(v)[at++]));
        }
    }
}

}  // namespace
}  // namespace edgewise
