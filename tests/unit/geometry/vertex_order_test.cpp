// SPDX-License-Identifier: MIT
//
// Other numbers for the same body: nothing is lost, the body is sound, names stay, and neighbours come closer
// where that is the aim.
//
// The vertex found through boxes is the one that a look at every vertex finds: on spheres, flat and far-off
// bodies, for planes that graze them by rounding steps.
//
// Rounding a body to single precision: its own topology, the names of the original input.
#include "edgewise/geometry/vertex_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <random>

#include "cones.hpp"
#include "edgewise/geometry/check_polyhedron.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/geometry/hull/vertex_boxes.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "geometry_bodies.hpp"

namespace edgewise {
namespace {

using testing::all_violations;
using testing::box_points;
using testing::Dice;
using testing::placed;
using testing::Points;
using testing::random_rotation;

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

std::optional<Index> first_of_all(const std::vector<Vec3d>& vertices, const Plane<double>& plane,
                                  double height) {
    for (Index v = 0; v < vertices.size(); ++v) {
        if (!(plane.distance(vertices[v]) <= height)) return v;
    }
    return {};
}

/// On an ellipsoid with these half axes around `centre`.
std::vector<Vec3d> ellipsoid(std::size_t count, const Vec3d& axes, const Vec3d& centre,
                             std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    std::vector<Vec3d> points(count);
    for (Vec3d& point : points) {
        point = Vec3d(normal(random), normal(random), normal(random)).normalized();
        point = centre + point.cwiseProduct(axes);
    }
    return points;
}

TEST(VertexBoxes, FindWhatALookAtAllFinds) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    int none = 0, some = 0;
    for (const std::size_t count : {1, 4, 17, 97, 1000, 6000}) {
        for (const Vec3d& axes :
             {Vec3d(1, 1, 1), Vec3d(1, 1e-9, 3), Vec3d(0, 1, 0), Vec3d(1e-30, 2e-30, 1e-30)}) {
            for (const double offset : {0.0, 1e6}) {
                const std::vector<Vec3d> vertices = ellipsoid(count, axes, Vec3d::Constant(offset), random);
                const VertexBoxes boxes(vertices);
                for (int i = 0; i < 60; ++i) {
                    const Vec3d direction =
                        Vec3d(normal(random), normal(random), normal(random)).normalized();
                    Plane<double> plane{direction, 0};
                    double highest = -std::numeric_limits<double>::infinity();
                    for (const Vec3d& v : vertices) highest = std::max(highest, plane.distance(v));
                    // Through the highest vertex, a few rounding steps over or under it, or well inside.
                    plane.offset = i % 6 == 5 ? -0.7 * highest : -highest * (1 + (i % 6 - 2) * 0x1p-52);
                    const auto expected = first_of_all(vertices, plane, 0);
                    ASSERT_EQ(boxes.first_above(plane, 0), expected) << count << ' ' << axes.transpose();
                    ++(expected ? some : none);
                }
            }
        }
    }
    std::printf("%d planes with a vertex above, %d without\n", some, none);
    EXPECT_GT(none, 100);
    EXPECT_GT(some, 100);
}

TEST(VertexBoxes, CountsWhatIsNoNumberAsAbove) {
    const std::vector<Vec3d> vertices(40, Vec3d(1, 2, 3));
    const VertexBoxes boxes(vertices);
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(boxes.first_above({Vec3d(1, 0, 0), none}, 0), Index{0});
    EXPECT_EQ(boxes.first_above({Vec3d(none, 0, 0), -9}, 0), Index{0});
    EXPECT_EQ(boxes.first_above({Vec3d(1, 0, 0), -9}, 0), std::nullopt);
}

// The expected values are spelled out, since casts in the test would go wrong the same way as casts in the
// code.
TEST(RoundToSingle, RoundsEveryCoordinate) {
    const double tenth = 0x1.99999ap-4;
    EXPECT_EQ(to_single(0.1), tenth);
    EXPECT_EQ(to_single(Vec3d(0.1, 0.2, 0.4)), Vec3d(tenth, 2 * tenth, 4 * tenth));
    const Result<Polyhedron> box = convex_hull(box_points(Vec3d(0.1, 0.2, 0.4)));
    ASSERT_TRUE(box) << box.error;
    const Result<Polyhedron> rounded = round_to_single(*box);
    ASSERT_TRUE(rounded) << rounded.error;
    EXPECT_EQ(rounded->vertices, box_points(Vec3d(tenth, 2 * tenth, 4 * tenth)));
}

TEST(RoundToSingle, IsTheHullOfTheRoundedVertices) {
    Dice dice(17);
    int bent = 0;
    for (int trial = 0; trial < 30; ++trial) {
        Points points = placed(box_points(Vec3d(1, 1, 1)), random_rotation(dice), dice.vector(), 1);
        points.insert(points.begin(), Vec3d(points[0] * 0.5 + points[7] * 0.5));
        const Result<Polyhedron> box = convex_hull(points);
        ASSERT_TRUE(box) << box.error;
        const Result<Polyhedron> rounded = round_to_single(*box);
        ASSERT_TRUE(rounded) << rounded.error;
        EXPECT_EQ(all_violations(*rounded), "");
        for (std::size_t v = 0; v < rounded->vertex_count(); ++v) {
            const Vec3d single = to_single(points[rounded->input_index[v]]);
            EXPECT_EQ(rounded->vertices[v], single);
        }
        bent += rounded->face_count() > 6;  // rounded corners of a tilted quad are not coplanar
    }
    EXPECT_GT(bent, 20);
}

TEST(RoundToSingle, SaysWhatSinglePrecisionLoses) {
    const Result<Polyhedron> far =
        convex_hull(placed(box_points(Vec3d(1, 1, 1)), Mat3d::Identity(), Vec3d(1e9, 0, 0), 1));
    ASSERT_TRUE(far) << far.error;
    const Result<Polyhedron> flat = round_to_single(*far);
    ASSERT_TRUE(flat) << flat.error;
    EXPECT_LT(flat->face_count(), 3U);
    EXPECT_NE(flat.warning.find("flat in single precision"), std::string::npos) << flat.warning;

    const Result<Polyhedron> huge = convex_hull(box_points(Vec3d(1e39, 1e39, 1e39)));
    ASSERT_TRUE(huge);
    const Result<Polyhedron> overflow = round_to_single(*huge);
    EXPECT_FALSE(overflow);
    EXPECT_NE(overflow.error.find("vertex 0"), std::string::npos) << overflow.error;

    Points close = box_points(Vec3d(1, 1, 1));
    close.push_back(Vec3d(1 + 1e-9, 0, 0));
    const Result<Polyhedron> roof = convex_hull(close);
    ASSERT_TRUE(roof);
    ASSERT_EQ(roof->vertex_count(), 9u);
    const Result<Polyhedron> box = round_to_single(*roof);
    ASSERT_TRUE(box) << box.error;
    EXPECT_EQ(box->vertex_count(), 8u);
    EXPECT_EQ(box.warning, "1 of 9 vertices vanish in single precision");
}

}  // namespace
}  // namespace edgewise
