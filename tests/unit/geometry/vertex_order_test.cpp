// SPDX-License-Identifier: MIT
//
// Other numbers for the same body: nothing is lost, the body is sound, names stay, and neighbours come closer
// where that is the aim.
#include "edgewise/geometry/vertex_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/geometry/hull.hpp"
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

}  // namespace
}  // namespace edgewise
