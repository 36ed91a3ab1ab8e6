// SPDX-License-Identifier: MIT
//
// Numbers of half-edges where a vertex has more neighbours than its part of the number can count.
#include <gtest/gtest.h>

#include <set>

#include "cones.hpp"
#include "edgewise/layouts/lean.hpp"

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

}  // namespace
}  // namespace edgewise
