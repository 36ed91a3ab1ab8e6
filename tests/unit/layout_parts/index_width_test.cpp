// SPDX-License-Identifier: MIT
//
// The widths of a narrow table's indices at their limits.
#include <gtest/gtest.h>

#include "edgewise/layouts/lean.hpp"
#include "round_body.hpp"

namespace edgewise {
namespace {

TEST(IndexWidth, IndicesWidenAtTheirLimits) {
    const auto width = [](std::size_t largest) {
        BlockPlan plan;
        return NarrowArray(plan, 3, largest).width();
    };
    EXPECT_EQ(width(255), 1U);
    EXPECT_EQ(width(256), 2U);
    EXPECT_EQ(width(65535), 2U);
    EXPECT_EQ(width(65536), 4U);
    for (const std::size_t largest : {255U, 256U, 65535U, 65536U}) {
        BlockPlan plan;
        NarrowArray array(plan, 2, largest);
        const Block block(plan);
        array.fill(block, [&](Index i) { return i == 0 ? static_cast<Index>(largest) : 7; });
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
