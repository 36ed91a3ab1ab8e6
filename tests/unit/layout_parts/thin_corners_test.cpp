// SPDX-License-Identifier: MIT
//
// Derived planes of faces with corners within a rounding step to their own size of a line, compared with
// those of the body, which are computed in wider arithmetic; and V-Clip on bodies of such faces, compared
// with exact arithmetic.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/geometry/hull.hpp"
#include "edgewise/layout_parts/derived/thin_corners.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/truth/exact_distance.hpp"
#include "reference_table.hpp"

namespace edgewise {
namespace {

/// A tetrahedron with its fourth corner near the middle of a side, on a face or near another corner;
/// coordinates are those of `Scalar`. Nothing where rounding leaves no body.
template <class Scalar>
Result<Polyhedron> needle(scene::Rng& rng, double smallest) {
    std::vector<Vec3d> corners;
    for (int i = 0; i < 4; ++i) corners.push_back(rng.in_cube(1));
    const double aside = std::pow(10.0, rng.uniform(std::log10(smallest), 0));
    const double place = rng.below(2) == 0 ? std::pow(10.0, rng.uniform(-7, 0)) : rng.uniform(0, 1);
    corners.push_back(corners[0] + place * (corners[1] - corners[0]) + aside * rng.in_cube(1));
    for (Vec3d& v : corners) v = cast<double>(cast<Scalar>(v));
    return convex_hull(corners);
}

/// Radians: of faces' planes; of planes through sides, off the side and about it. Relative to the bodies'
/// size of about 1: of distances.
struct NeedleErrors {
    double worst_angle = 0, worst_off_side = 0, worst_tilt = 0, worst_distance = 0;
    int thin_bodies = 0, fair_bodies = 0, separated = 0, overlapping = 0, planes = 0;
};

template <class Plane>
Vec3d unit(const Plane& plane) {
    const Vec3d normal = cast<double>(plane.normal);
    return normal / norm(normal);
}

/// Angle between a derived plane's normal and one computed in wider arithmetic.
template <class Plane>
double angle_to(const Plane& plane, const Vec3d& exact) {
    return norm(Vec3d(cross(unit(plane), exact)));
}

template <class Table>
void compare_planes(const Table& table, const Polyhedron& body, NeedleErrors& errors) {
    const ReferenceTable reference(body);
    for (Index e = 0; e < body.edge_count(); ++e) {
        const PolyhedronEdge& edge = body.edges[e];
        for (const auto [found, flipped] : table.ring_of_vertex(edge.tail)) {
            if (table.tail(found) + table.head(found) != edge.tail + edge.head) continue;
            const bool as_ours = table.tail(found) == edge.tail;
            for (const Side side : {Side::left, Side::right}) {
                const bool left = (side == Side::left) == as_ours;
                const auto exact = reference.edge_face_plane(e, left ? Side::left : Side::right);
                const auto beside = table.edge_face_plane(found, side);
                const auto face = side == Side::left ? table.left(found) : table.right(found);
                ++errors.planes;
                errors.worst_tilt = std::max(errors.worst_tilt, angle_to(beside, exact.normal));
                errors.worst_off_side =
                    std::max(errors.worst_off_side, std::abs(dot(unit(beside), reference.direction(e))));
                errors.worst_angle = std::max(
                    errors.worst_angle,
                    angle_to(table.face_plane(face), body.face_planes[left ? edge.left : edge.right].normal));
            }
        }
    }
}

template <class Table>
void compare_distances(const Table& table, const Polyhedron& body, scene::Rng& rng, NeedleErrors& errors) {
    for (int i = 0; i < 6; ++i) {
        const Vec3d corner_a = body.vertices[rng.below(body.vertex_count())];
        const Vec3d corner_b = body.vertices[rng.below(body.vertex_count())];
        const double gap = std::pow(10.0, rng.uniform(-3, 0));
        Pose pose;
        pose.rotation = rng.rotation();
        pose.translation = corner_a - multiply(pose.rotation, corner_b) + gap * rng.on_sphere();
        FeaturePair<Table, Table> pair(table, table);
        const Distance answer = VClip::query(table, table, {pose.rotation, pose.translation}, pair);
        const auto exact = truth::exact_distance(body.vertices, Pose{}, body.vertices, pose).or_throw();
        errors.worst_distance = std::max(errors.worst_distance, std::abs(answer.distance - exact.distance));
        ++(exact.distance > 0 ? errors.separated : errors.overlapping);
    }
}

template <Precision P>
NeedleErrors errors_of_needles(double smallest) {
    scene::Rng rng(11);
    NeedleErrors errors;
    for (int i = 0; i < 1500; ++i) {
        const Result<Polyhedron> body = needle<typename P::Compute>(rng, smallest);
        if (!body) continue;
        const lean<P> table(*body, Parts::features);
        ++(table.facts().thin_corners ? errors.thin_bodies : errors.fair_bodies);
        // A hull may merge faces that are bent by rounding: of four corners, planes are a choice.
        if (body->face_ring.size() == 3 * body->face_count()) compare_planes(table, *body, errors);
        compare_distances(table, *body, rng, errors);
    }
    std::printf(
        "faces off by %.3g, planes through sides off the side by %.3g and tilted by %.3g, worst distance %.3g; "
        "%d thin bodies, %d fair, %d separated, %d overlapping\n",
        errors.worst_angle, errors.worst_off_side, errors.worst_tilt, errors.worst_distance,
        errors.thin_bodies, errors.fair_bodies, errors.separated, errors.overlapping);
    const double eps = Tolerance<typename P::Compute>::eps;
    EXPECT_LT(errors.worst_angle, 64 * eps);
    EXPECT_LT(errors.worst_off_side, 64 * eps);
    EXPECT_GT(errors.thin_bodies, 200);
    EXPECT_GT(errors.fair_bodies, 10);
    EXPECT_GT(errors.planes, 10000);
    EXPECT_GT(errors.separated, 2000);
    EXPECT_GT(errors.overlapping, 2000);
    return errors;
}

TEST(ThinCorners, HaveAccuratePlanesAndDistancesInDouble) {
    const NeedleErrors errors = errors_of_needles<f64>(1e-14);
    EXPECT_LT(errors.worst_tilt, verified_error_double);
    EXPECT_LT(errors.worst_distance, verified_error_double);
}

TEST(ThinCorners, HaveAccuratePlanesAndDistancesInSingle) {
    const NeedleErrors errors = errors_of_needles<f32>(1e-6);
    EXPECT_LT(errors.worst_tilt, verified_error_single);
    EXPECT_LT(errors.worst_distance, verified_error_single);
}

/// Named shapes derive their planes plainly: the checks would cost time.
TEST(ThinCorners, AreNotOnSpheresAndBoxes) {
    for (const char* name : {"cube8", "sphere38", "sphere386", "sphere1538"}) {
        const Polyhedron body = *scene::make_shape(name);
        const double reach = lean<f64>(body, Parts::support).reach();
        EXPECT_FALSE(has_thin_corners<double>(body, reach)) << name;
        EXPECT_FALSE(has_thin_corners<float>(body, reach)) << name;
    }
}

}  // namespace
}  // namespace edgewise
