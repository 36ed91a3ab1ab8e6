// SPDX-License-Identifier: MIT
//
// Support points: scan and climb, from any start, beside a plain maximum over all vertices.
#include "edgewise/algorithms/support.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/canonical.hpp"

namespace edgewise {
namespace {

/// The first of the highest vertices.
Index highest(const Polyhedron& body, const Vec3d& direction) {
    Index best = 0;
    for (Index v = 1; v < body.vertex_count(); ++v) {
        if (dot(body.vertices[v], direction) > dot(body.vertices[best], direction)) best = v;
    }
    return best;
}

class Support : public ::testing::TestWithParam<std::string> {};

TEST_P(Support, ScanAndClimbFindTheHighestVertex) {
    const auto body = scene::make_shape(GetParam());
    ASSERT_TRUE(body) << body.error;
    const Canonical table(*body);
    scene::Rng rng(1);
    double worst = 0;
    for (int i = 0; i < 5000; ++i) {
        Vec3d direction = rng.on_sphere();
        if (i % 4 == 0) direction = (direction * 1.5).array().round();  // lattice: equal vertices
        if (i % 4 == 1) direction = body->face_planes[rng.below(body->face_count())].normal;
        const double top = dot(body->vertices[highest(*body, direction)], direction);
        const auto start = static_cast<Index>(rng.below(body->vertex_count()));
        const auto scanned = scan_support(table, direction);
        const auto climbed = climb_support(table, direction, start);
        const auto chosen = support(table, direction, start);
        EXPECT_EQ(scanned.vertex, highest(*body, direction));
        for (const auto& found : {scanned, climbed, chosen}) {
            EXPECT_EQ(found.point, body->vertices[found.vertex]);
            EXPECT_EQ(found.along, dot(found.point, direction));
            worst = std::max(worst, top - found.along);
        }
    }
    std::printf("support %s: worst shortfall %.3g\n", GetParam().c_str(), worst);
    EXPECT_LT(worst, 1e-14);  // among vertices that rounding cannot tell apart
}

INSTANTIATE_TEST_SUITE_P(Shapes, Support, ::testing::Values("tetra4", "cube8", "sphere18", "sphere386"),
                         [](const auto& shape) { return shape.param; });

}  // namespace
}  // namespace edgewise
