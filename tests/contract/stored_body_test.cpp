// SPDX-License-Identifier: MIT
//
// A table holds the body that stored_body(b) returns, vertex by vertex; stored_body of that body is the same
// body. (A grid that was computed again from the rounded body was once twice as wide, and the table held
// another body.)
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "stored_bodies.hpp"
#include "tables_under_test.hpp"

namespace edgewise {
namespace {

template <class Type>
class StoredBody : public ::testing::Test {};
TYPED_TEST_SUITE(StoredBody, TableTypes);

/// Round, thin, needle-shaped and flat bodies; at their own size, tiny, huge, and with a side slightly below,
/// at or above a power of two, where the step of a grid doubles.
std::vector<Polyhedron> bodies_of_every_kind() {
    const std::vector<Vec3d> shapes = {
        {1, 0.7, 0.4}, {1, 1, 1e-7}, {1, 1e-5, 1e-5}, {1, 0.3, 0}, {1, 1e-9, 0.2}};
    std::vector<Polyhedron> bodies;
    scene::Rng rng(11);
    for (const Vec3d& shape : shapes) {
        for (const double size : {1.0, 0x1p-12, 0x1p12, 0.99998, 0.99999, 1.00001}) {
            for (int corners : {4, 5, 12}) {
                std::vector<Vec3d> points;
                for (int i = 0; i < corners; ++i)
                    points.push_back(rng.on_sphere().cwiseProduct(shape) * size);
                points.push_back(Vec3d(-size, 0, 0));
                points.push_back(Vec3d(size, 0, 0));
                auto body = hull_of_any(points);
                EXPECT_TRUE(body) << body.error;
                bodies.push_back(*std::move(body));
            }
        }
    }
    return bodies;
}

/// For layouts that hold nothing else: from plates to beams, at the same sizes.
std::vector<Polyhedron> boxes_of_every_kind() {
    std::vector<Polyhedron> bodies;
    for (const Vec3d& shape :
         {Vec3d(1, 0.7, 0.4), Vec3d(1, 1, 1e-7), Vec3d(1, 1e-5, 1e-5), Vec3d(1, 1e-9, 0.2)})
        for (const double size : {1.0, 0x1p-12, 0x1p12, 0.99998, 0.99999, 1.00001})
            for (const int first : {0, 1, 2})
                bodies.push_back(
                    centred_box(size * Vec3d(shape[first], shape[(first + 1) % 3], shape[(first + 2) % 3])));
    return bodies;
}

[[maybe_unused]] std::vector<Vec3d> sorted(std::vector<Vec3d> points) {
    std::ranges::sort(points, [](const Vec3d& p, const Vec3d& q) {
        return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
    });
    return points;
}

TYPED_TEST(StoredBody, IsWhatTheTableHolds) {
    using Table = typename TypeParam::Table;
    int held = 0, refused = 0;
    std::vector<Polyhedron> bodies = bodies_of_every_kind();
    if (!holds<Table>(bodies[0])) bodies = boxes_of_every_kind();
    for (const Polyhedron& given : bodies) {
        const auto stored = stored_body<Table>(given);
        refused += !stored;
        if (!stored) continue;
        ++held;
        const auto again = stored_body<Table>(*stored);
        ASSERT_TRUE(again) << again.error;
        // A layout with its own order of vertices may reorder them.
        if constexpr (requires { Table::vertex_order; }) {
            EXPECT_EQ(sorted(again->vertices), sorted(stored->vertices));
        } else {
            EXPECT_EQ(again->vertices, stored->vertices);
            EXPECT_EQ(again->face_ring, stored->face_ring);
        }
        const Table table(*stored, has_features<Table> ? Parts::features : Parts::support);
        Index index = 0;
        for (const auto v : table.all_vertices())
            ASSERT_EQ(Vec3d(cast<double>(table.vertex(v))), stored->vertices[index++]);
        EXPECT_EQ(index, stored->vertex_count());
    }
    std::printf("%d bodies held, %d refused\n", held, refused);
    EXPECT_GT(held, 60);
}

}  // namespace
}  // namespace edgewise
