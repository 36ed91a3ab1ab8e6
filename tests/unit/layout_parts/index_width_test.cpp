// SPDX-License-Identifier: MIT
//
// The widths of a narrow table's indices at their limits.
#include <gtest/gtest.h>

#include "edgewise/layouts/lean.hpp"
#include "round_body.hpp"

namespace edgewise {
namespace {

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
