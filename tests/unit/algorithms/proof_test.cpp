// SPDX-License-Identifier: MIT
//
// The proof that a body ends at a feature along a direction, compared with a plain maximum over all vertices.
#include "edgewise/algorithms/vclip/proof.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "edgewise/layouts/aos.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "folded_pyramid.hpp"

namespace edgewise {
namespace {

using Table = aos<f64>;

/// How far the body goes on beyond the point along the direction; negative where all of it lies behind.
double beyond(const Polyhedron& body, const Vec3d& point, const Vec3d& direction) {
    double most = dot(Vec3d(body.vertices[0] - point), direction);
    for (const Vec3d& vertex : body.vertices) most = std::max(most, dot(Vec3d(vertex - point), direction));
    return most;
}

Vec3d middle_of(const Table& table, Table::Face face) {
    Vec3d sum = Vec3d::Zero();
    int corners = 0;
    for (const auto [edge, flipped] : table.ring_of_face(face)) {
        sum += table.vertex(flipped ? table.head(edge) : table.tail(edge));
        ++corners;
    }
    return sum / corners;
}

struct AskedFaces {
    int ends = 0, goes_on = 0;
};

/// Every face, from its middle, along directions all around it.
AskedFaces ask_faces(const Polyhedron& body) {
    const Table table(body, Parts::features);
    const Transform<double> still{Mat3d::Identity(), Vec3d::Zero()};
    scene::Rng rng(5);
    AskedFaces asked;
    for (const auto face : table.all_faces()) {
        const vclip::Body<Table> at_face{table, still, Feature<Table>::of_face(face)};
        const Vec3d middle = middle_of(table, face), normal = table.face_plane(face).normal;
        for (int i = 0; i < 200; ++i) {
            const Vec3d direction = i % 2 == 0 ? Vec3d(i % 4 == 0 ? normal : -normal) : rng.on_sphere();
            const bool goes_on = beyond(body, middle, direction) > 1e-9;
            ++(goes_on ? asked.goes_on : asked.ends);
            EXPECT_EQ(vclip::ends_at(at_face, middle, direction), !goes_on) << direction.transpose();
        }
    }
    return asked;
}

TEST(Proof, AsksAllVerticesForFacesOfBodiesThatCannotBeClimbed) {
    const Polyhedron body = testing::folded_pyramid(0);
    EXPECT_FALSE(may_climb(Table(body, Parts::features)));
    const AskedFaces asked = ask_faces(body);
    std::printf("faces end %d times, the body goes on %d times\n", asked.ends, asked.goes_on);
    EXPECT_GT(asked.ends, 50);
    EXPECT_GT(asked.goes_on, 50);
}

/// What a state saw above a face of a body that can be climbed needs no look at the rest of it.
TEST(Proof, TakesTheWordOfAFacesStateOfBodiesThatCanBeClimbed) {
    const Polyhedron body = scene::make_shape("sphere38").or_throw();
    const Table table(body, Parts::features);
    ASSERT_TRUE(may_climb(table));
    const Transform<double> still{Mat3d::Identity(), Vec3d::Zero()};
    for (const auto face : table.all_faces()) {
        const vclip::Body<Table> at_face{table, still, Feature<Table>::of_face(face)};
        const Vec3d middle = middle_of(table, face), normal = table.face_plane(face).normal;
        EXPECT_LE(beyond(body, middle, normal), 1e-12);
        EXPECT_TRUE(vclip::ends_at(at_face, middle, normal));
    }
}

}  // namespace
}  // namespace edgewise
