// SPDX-License-Identifier: MIT
//
// The order of small bandwidth, on spheres whose bandwidth under reverse Cuthill-McKee is known, on bodies
// with a vertex of very many neighbours, and whatever order a body is given in.
#include "edgewise/geometry/bandwidth_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "cones.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/vertex_order.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise {
namespace {

Polyhedron in_random_order(std::vector<Vec3d> points) {
    scene::Rng rng(points.size());
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[rng.below(i)]);
    return convex_hull(points).or_throw();
}

TEST(BandwidthOrder, ReachesTheBandwidthsThatAreKnownOfSpheres) {
    const std::pair<const char*, Index> known[] = {{"sphere38", 14},   {"sphere102", 22},  {"sphere258", 34},
                                                   {"sphere402", 42},  {"sphere678", 54},  {"sphere1026", 66},
                                                   {"sphere1938", 90}, {"sphere3846", 126}};
    for (const auto& [shape, expected] : known) {
        const Polyhedron body = in_random_order(scene::make_shape(shape).or_throw().vertices);
        const Index found = bandwidth(reordered(body, VertexOrder::rcm).or_throw());
        std::printf("%zu vertices: bandwidth %u, %u as given\n", body.vertex_count(), found, bandwidth(body));
        EXPECT_LE(found, expected);
        EXPECT_GT(bandwidth(body), expected);
    }
}

void expect_every_vertex_once(const Polyhedron& body) {
    std::vector<Index> order = bandwidth_order(body), all(body.vertex_count());
    std::sort(order.begin(), order.end());
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(order, all) << body.vertex_count() << " vertices";
}

TEST(BandwidthOrder, NamesEveryVertexOnceAndIsNoWorse) {
    for (const char* shape : {"tetra4", "cube8", "sphere38", "uv_sphere386", "sphere1538"}) {
        const Polyhedron body = scene::make_shape(shape).or_throw();
        expect_every_vertex_once(body);
        EXPECT_LE(bandwidth(reordered(body, VertexOrder::rcm).or_throw()), bandwidth(body)) << shape;
    }
}

/// Of a vertex beside all others, half of these or more lie on one side of it in any order.
TEST(BandwidthOrder, TakesAVertexOfVeryManyNeighbours) {
    const Polyhedron body = in_random_order(testing::pyramid(400).vertices);
    ASSERT_EQ(body.vertex_count(), 401U);
    expect_every_vertex_once(body);
    EXPECT_GE(bandwidth(body), 200U);
    EXPECT_GE(bandwidth(reordered(body, VertexOrder::rcm).or_throw()), 200U);
}

}  // namespace
}  // namespace edgewise
