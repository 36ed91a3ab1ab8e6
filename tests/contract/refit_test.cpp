// SPDX-License-Identifier: MIT
//
// Compares a table that is refitted to a deformed body of the same topology with a new table of that body:
// the answers have the same bits, and memory does not grow.
#include <gtest/gtest.h>

#include <cstdio>

#include "counted_memory.hpp"
#include "edgewise/layout_parts/write_geometry.hpp"
#include "query_poses.hpp"
#include "stored_bodies.hpp"
#include "tables_under_test.hpp"

namespace edgewise {
namespace {

template <class Type>
class Refit : public ::testing::Test {};
TYPED_TEST_SUITE(Refit, TableTypes);

/// The body turned by a quarter and twice as large, which no storage rounds: every vertex and every face
/// plane changes, the rings do not.
Polyhedron deformed(const Polyhedron& body) {
    Polyhedron result = body;
    const auto turned = [](const Vec3d& v) { return Vec3d(-v.y(), v.x(), v.z()); };
    for (Vec3d& v : result.vertices) v = 2 * turned(v);
    for (Plane<double>& plane : result.face_planes) plane = {turned(plane.normal), 2 * plane.offset};
    return result;
}

template <class Algorithm, class T>
void expect_same_as_new(const Polyhedron& from, const Polyhedron& to, const std::string& name) {
    CountedMemory memory;
    const TablesIn placed(memory);
    T refitted(from, Algorithm::parts);
    const std::size_t before = memory.live_bytes();
    refit(refitted, to);
    EXPECT_EQ(memory.live_bytes(), before) << name;
    const T fresh(to, Algorithm::parts);
    EXPECT_EQ(refitted.strictly_convex(), fresh.strictly_convex()) << name;
    const auto poses = query_poses(60, to, 3);
    const auto expected = answers<Algorithm>(fresh, fresh, poses);
    const auto found = answers<Algorithm>(refitted, refitted, poses);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) expect_same_bits(found[i], expected[i]);
}

TYPED_TEST(Refit, AnswersAsANewTableDoes) {
    if constexpr (Refittable<typename TypeParam::Table>) {
        using T = typename TypeParam::Table;
        for (const auto& [name, body] : test_bodies<T>()) {
            const Polyhedron to = deformed(body);
            ASSERT_EQ(to.face_count(), body.face_count()) << name;
            for_each_algorithm<T>([&, &name = name, &body = body]<class Algorithm>(Algorithm) {
                expect_same_as_new<Algorithm, T>(body, to, name);
            });
        }
    } else {
        GTEST_SKIP() << "this layout cannot be refitted in place";
    }
}

}  // namespace
}  // namespace edgewise
