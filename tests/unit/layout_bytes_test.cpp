// SPDX-License-Identifier: MIT
//
// Bytes of narrow tables worked out by hand, the widths of indices at their limits, and the grid of
// `quantised`: what rounding to it moves.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/geometry/grid.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/single.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/quantised.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

struct Expected {
    const char* shape;
    std::size_t coordinates, topology, padding;
};

template <class Table>
void expect_bytes(const Expected& expected) {
    SCOPED_TRACE(std::string(Table::name) + " " + expected.shape);
    const auto body = stored_body<Table>(*make_shape(expected.shape));
    ASSERT_TRUE(body) << body.error;
    const Ledger ledger = Table(*body, Parts::features).ledger();
    EXPECT_EQ(ledger[Component::vertex_coordinates], expected.coordinates);
    EXPECT_EQ(ledger[Component::topology], expected.topology);
    EXPECT_EQ(ledger[Component::padding], expected.padding);
    EXPECT_EQ(ledger.total(), expected.coordinates + expected.topology + expected.padding);
}

// Coordinates; then V + 1 offsets and 2 E neighbours; each array from a new line of 64 bytes.
TEST(LayoutBytes, OfThreeBodiesByHand) {
    expect_bytes<lean<f64>>({"tetra4", 4 * 24, 5 + 12, (128 - 96) + (192 - 133)});
    expect_bytes<lean<f64>>({"cube8", 8 * 24, 9 + 24, 256 - 201});
    expect_bytes<lean<f64>>({"sphere386", 386 * 24, 387 * 2 + 2304 * 2, (9280 - 9264) + (10112 - 10054)});
    expect_bytes<lean<f32>>({"tetra4", 4 * 12, 5 + 12, (64 - 48) + (128 - 69)});
    expect_bytes<lean<f32>>({"cube8", 8 * 12, 9 + 24, (128 - 96) + (192 - 137)});
    expect_bytes<lean<f32>>({"sphere386", 386 * 12, 387 * 2 + 2304 * 2, (4672 - 4632) + (5504 - 5446)});
    expect_bytes<quantised<f64>>({"tetra4", 4 * 6, 5 + 12, (64 - 24) + (128 - 69)});
    expect_bytes<quantised<f64>>({"cube8", 8 * 6, 9 + 24, (64 - 48) + (128 - 73)});
    expect_bytes<quantised<f32>>({"sphere386", 386 * 6, 387 * 2 + 2304 * 2, (2368 - 2316) + (3200 - 3142)});
}

TEST(LayoutBytes, IndicesWidenAtTheirLimits) {
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

/// Points on a sphere, all of them corners of their hull.
Polyhedron spiral(int count) {
    std::vector<Vec3d> points;
    Rng rng(1);
    for (int i = 0; i < count; ++i) points.push_back(rng.on_sphere());
    return *convex_hull(points);
}

TEST(LayoutBytes, NeighboursOf256VerticesTakeOneByteAndOf257Two) {
    for (const int count : {256, 257}) {
        const Polyhedron body = spiral(count);
        ASSERT_EQ(body.vertex_count(), static_cast<std::size_t>(count));
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

TEST(Grid, MovesACoordinateByHalfAStepAtMostAndThenNoMore) {
    Rng rng(2);
    double worst = 0;
    for (int i = 0; i < 100; ++i) {
        const Vec3d far = 100 * rng.in_cube(1), size = Vec3d(1, 0.3, 0.01);
        std::vector<Vec3d> points;
        for (int k = 0; k < 40; ++k) points.push_back(far + rng.in_cube(1).cwiseProduct(size));
        for (const double eps : {0x1p-52, 0x1p-23}) {
            const Grid grid(points, eps);
            std::vector<Vec3d> moved;
            for (const Vec3d& p : points) {
                moved.push_back(grid.at(grid.nearest(p)));
                worst = std::max(worst, max_abs(Vec3d(moved.back() - p)) / grid.step);
                if (eps > 1e-10) {
                    EXPECT_EQ(moved.back(), to_single(moved.back()));
                }
            }
            const Grid again(moved, eps);
            for (const Vec3d& p : moved) EXPECT_EQ(again.at(again.nearest(p)), p);
        }
    }
    std::printf("moved by %.3f steps at most\n", worst);
    EXPECT_LE(worst, 0.5);
    EXPECT_GT(worst, 0.4);
}

}  // namespace
}  // namespace edgewise
