// SPDX-License-Identifier: MIT
//
// Compares every plane of a table with one that is derived here, in double and in another way: distances of
// random points with their signs, and the positive side that contract.hpp defines. A plane may be stored or
// derived; its normal has length one to the stored precision.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/geometry/hull.hpp"
#include "stored_bodies.hpp"
#include "tables_under_test.hpp"

namespace edgewise {
namespace {

template <class Type>
class Planes : public ::testing::Test {};
TYPED_TEST_SUITE(Planes, TableTypes);

/// Errors in rounding steps of the stored type, relative to the largest coordinate.
constexpr double allowed_steps = 8;

struct Worst {
    double steps = 0;
    int points = 0;
};

/// A plane to compare with; `conditioning` is its change, in steps, for one step of the coordinates.
struct Expected {
    Plane<double> plane;
    double conditioning = 1;
};

template <class T, class P>
void compare(const P& plane, const Expected& expected, const Polyhedron& body, scene::Rng& rng,
             Worst& worst) {
    for (int i = 0; i < 4; ++i) {
        const Vec3d p = to_single(Vec3d(body.vertices[rng.below(body.vertex_count())] + rng.in_cube(2)));
        // The normal of a derived plane need not have length one.
        const double found = static_cast<double>(plane.distance(cast<ComputeOf<T>>(p))) /
                             norm(Vec3d(plane.normal.template cast<double>()));
        const double size = std::max(1.0, std::max(max_abs(p), std::abs(expected.plane.offset)));
        const double error = std::abs(found - expected.plane.distance(p));
        worst.steps = std::max(worst.steps, error / (stored_eps<T> * size * expected.conditioning));
        ++worst.points;
    }
}

Vec3d mean_of_face(const Polyhedron& body, Index f) {
    Vec3d sum = Vec3d::Zero();
    for (const HalfEdge h : body.ring_of_face(f)) sum += body.vertices[body.tail(h)];
    return sum / static_cast<double>(body.ring_of_face(f).size());
}

Plane<double> through(const Vec3d& normal, const Vec3d& point) {
    const Vec3d unit = normal / norm(normal);
    return {unit, -dot(unit, point)};
}

/// Plane at the start of half-edge h, positive beyond the start.
Expected beyond_start(const Polyhedron& body, HalfEdge h) {
    const Vec3d& start = body.vertices[body.tail(h)];
    return {through(start - body.vertices[body.head(h)], start)};
}

/// Plane through half-edge h, perpendicular to its face, positive on the side of the face's centre. Rounding
/// turns it more if that centre is closer to the edge.
Expected towards_face(const Polyhedron& body, HalfEdge h) {
    const Vec3d& start = body.vertices[body.tail(h)];
    const Vec3d along = body.vertices[body.head(h)] - start;
    const Vec3d inward = mean_of_face(body, body.face(h)) - start;
    const Vec3d square = inward - dot(inward, along) / squared_norm(along) * along;
    return {through(square, start), std::max(1.0, max_abs(start) / norm(square))};
}

template <class T>
void compare_edge_planes(const T& table, const Polyhedron& body, scene::Rng& rng, Worst& worst) {
    for (const auto v : table.all_vertices()) {
        std::size_t at = 0;
        for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
            const HalfEdge h = body.ring_of_vertex(table.index_of(v))[at++];
            const auto end = flipped ? End::head : End::tail;
            compare<T>(table.vertex_edge_plane(edge, end), beyond_start(body, h), body, rng, worst);
            const auto side = flipped ? Side::right : Side::left;
            compare<T>(table.edge_face_plane(edge, side), towards_face(body, h), body, rng, worst);
        }
    }
}

TYPED_TEST(Planes, VoronoiPlanesAreTheDerivedOnes) {
    scene::Rng rng(1);
    for_each_feature_table<typename TypeParam::Table>(
        [&](const auto& table, const Polyhedron& body, const std::string& name) {
            Worst worst;
            compare_edge_planes(table, body, rng, worst);
            std::printf("%s %s: Voronoi planes within %.2g steps over %d points\n", TypeParam::name,
                        name.c_str(), worst.steps, worst.points);
            EXPECT_LE(worst.steps, allowed_steps);
            EXPECT_EQ(worst.points, 16 * static_cast<int>(body.edge_count()));
        });
}

/// Square of a face's extent over its area: the change of a normal derived from corners per rounding of the
/// corners.
[[maybe_unused]] double flatness(const Polyhedron& body, Index face) {
    std::vector<Vec3d> corners;
    for (const HalfEdge h : body.ring_of_face(face)) corners.push_back(body.vertices[body.tail(h)]);
    Vec3d area = Vec3d::Zero();
    for (std::size_t i = 2; i < corners.size(); ++i)
        area += cross(Vec3d(corners[i - 1] - corners[0]), Vec3d(corners[i] - corners[0]));
    return std::max(1.0, extent(corners) * extent(corners) / norm(area));
}

TYPED_TEST(Planes, FacePlanesAreOutwardAndHoldTheirVertices) {
    scene::Rng rng(2);
    for_each_feature_table<typename TypeParam::Table>([&]<class T>(const T& table, const Polyhedron& body,
                                                                   const std::string& name) {
        Worst worst;
        for (const auto f : table.all_faces()) {
            const Index face = body_face(table, f, body);
            const auto plane = table.face_plane(f);
            const double flat = DerivesPlanes<T> ? flatness(body, face) : 1;
            const double tolerance =
                allowed_steps * stored_eps<T> * (1 + std::abs(body.face_planes[face].offset)) * flat;
            compare<T>(plane, {body.face_planes[face], flat}, body, rng, worst);
            EXPECT_NEAR(norm(Vec3d(plane.normal.template cast<double>())), 1, allowed_steps * stored_eps<T>);
            for (const auto v : table.all_vertices()) EXPECT_LE(plane.distance(table.vertex(v)), tolerance);
            for (const HalfEdge h : body.ring_of_face(face)) {
                const auto corner = cast<ComputeOf<T>>(body.vertices[body.tail(h)]);
                EXPECT_LE(std::abs(plane.distance(corner)), tolerance);
            }
        }
        std::printf("%s %s: face planes within %.2g steps over %d points\n", TypeParam::name, name.c_str(),
                    worst.steps, worst.points);
        EXPECT_LE(worst.steps, allowed_steps);
    });
}

TYPED_TEST(Planes, DirectionsRunFromTailToHead) {
    double worst = 0;
    for_each_feature_table<typename TypeParam::Table>(
        [&]<class T>(const T& table, const Polyhedron& body, const std::string& /*name*/) {
            for (const auto v : table.all_vertices()) {
                for (const auto [edge, flipped] : table.ring_of_vertex(v)) {
                    const Vec3d along = body.vertices[table.index_of(table.head(edge))] -
                                        body.vertices[table.index_of(table.tail(edge))];
                    const Vec3d given = table.direction(edge).template cast<double>();
                    const Vec3d found = given / norm(given);
                    worst = std::max(worst, max_abs(Vec3d(found - along / norm(along))) / stored_eps<T>);
                }
            }
            EXPECT_LE(worst, allowed_steps);
        });
    std::printf("%s: directions within %.2g steps\n", TypeParam::name, worst);
}

}  // namespace
}  // namespace edgewise
