// SPDX-License-Identifier: MIT
//
// Other numbers for the same body: nothing is lost, the body is sound, names stay, and neighbours come closer
// where that is the aim.
#include "edgewise/geometry/vertex_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>

#include "cones.hpp"
#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise {
namespace {

constexpr VertexOrder all_orders[] = {VertexOrder::given, VertexOrder::bfs, VertexOrder::spatial,
                                      VertexOrder::rcm};

/// Mean distance in numbers between neighbours.
double mean_jump(const Polyhedron& body) {
    double sum = 0;
    for (const PolyhedronEdge& e : body.edges) sum += std::abs(double(e.tail) - double(e.head));
    return sum / static_cast<double>(body.edge_count());
}

TEST(VertexOrder, IsTheSameBodyUnderOtherNumbers) {
    for (const char* shape : {"tetra4", "cube8", "sphere38", "sphere386", "uv_sphere386"}) {
        const Polyhedron body = *scene::make_shape(shape);
        for (const VertexOrder order : all_orders) {
            SCOPED_TRACE(std::string(shape) + " " + std::string(to_string(order)));
            const auto other = reordered(body, order);
            ASSERT_TRUE(other) << other.error;
            for (const std::string& violation : check_polyhedron(*other)) ADD_FAILURE() << violation;
            ASSERT_EQ(other->vertex_count(), body.vertex_count());
            EXPECT_EQ(other->edge_count(), body.edge_count());
            EXPECT_EQ(other->face_count(), body.face_count());
            std::vector<Index> names = other->input_index;
            for (Index v = 0; v < names.size(); ++v) {
                const auto in_body = std::find(body.input_index.begin(), body.input_index.end(), names[v]);
                EXPECT_EQ(other->vertices[v], body.vertices[in_body - body.input_index.begin()]);
            }
            std::sort(names.begin(), names.end());
            EXPECT_EQ(std::unique(names.begin(), names.end()), names.end());
        }
    }
}

TEST(VertexOrder, GivenIsTheBodyItself) {
    const Polyhedron body = *scene::make_shape("sphere38");
    EXPECT_EQ(reordered(body, VertexOrder::given)->vertices, body.vertices);
}

/// A breadth-first front is one ring wide, a curve stays in its neighbourhood; shuffled is the worst there
/// is.
TEST(VertexOrder, BringsNeighboursTogether) {
    for (const char* shape : {"sphere386", "uv_sphere386", "sphere1538"}) {
        const Polyhedron body = *scene::make_shape(shape);
        const double given = mean_jump(body), bfs = mean_jump(*reordered(body, VertexOrder::bfs)),
                     spatial = mean_jump(*reordered(body, VertexOrder::spatial));
        std::printf("%s: neighbours are %.1f apart as given, %.1f breadth first, %.1f along the curve\n",
                    shape, given, bfs, spatial);
        const double shuffled = static_cast<double>(body.vertex_count()) / 3;
        EXPECT_LT(bfs, shuffled / 2);
        EXPECT_LT(spatial, shuffled / 2);
    }
}

TEST(VertexOrder, FlatBodiesStayAsTheyAre) {
    const std::vector<Vec3d> corners = {{1, 0, 0.5}, {0, 1, 0.25}, {-1, 0, -0.5}, {0.5, -1, 0}};
    const Polyhedron body = *hull_of_any(corners);
    EXPECT_EQ(reordered(body, VertexOrder::spatial)->vertices, body.vertices);
}

TEST(VertexOrder, HasNames) {
    for (const VertexOrder order : all_orders) EXPECT_EQ(vertex_order_from(to_string(order)), order);
    EXPECT_FALSE(vertex_order_from("alphabetical"));
}

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

/// In any order, half of the vertices or more lie on one side of a neighbour of them all.
TEST(BandwidthOrder, TakesAVertexOfVeryManyNeighbours) {
    const Polyhedron body = in_random_order(testing::pyramid(400).vertices);
    ASSERT_EQ(body.vertex_count(), 401U);
    expect_every_vertex_once(body);
    EXPECT_GE(bandwidth(body), 200U);
    EXPECT_GE(bandwidth(reordered(body, VertexOrder::rcm).or_throw()), 200U);
}

}  // namespace
}  // namespace edgewise
