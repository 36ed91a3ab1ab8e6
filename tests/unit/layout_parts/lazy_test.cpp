// SPDX-License-Identifier: MIT
//
// Compares lazy tables over storing layouts of every kind with the layout itself: answers are the same bit by
// bit, every plane is the same after its first read, and no plane is computed before it is read.
#include "edgewise/layouts/lazy.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/bench/memory/arena.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/aosoa.hpp"
#include "edgewise/layouts/hot_cold.hpp"
#include "edgewise/layouts/ring.hpp"
#include "edgewise/layouts/shared_plane.hpp"
#include "edgewise/layouts/soa.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/contract.hpp"
#include "edgewise/table/stored_body.hpp"

namespace edgewise {
namespace {

template <class Layout>
using LazyLayout = Lazy<Layout, Direct>;

template <class Layout>
class LazyTable : public ::testing::Test {};
using StoringLayouts =
    ::testing::Types<aos<f32>, aosoa<f32>, hot_cold<f64>, ring<mixed>, shared_plane<f64>, soa<f64>>;
TYPED_TEST_SUITE(LazyTable, StoringLayouts);

static_assert(queries_write<lazy<f64>> && !queries_write<hot_cold<f64>>);

template <class P>
void expect_same_plane(const P& a, const P& b) {
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.offset, b.offset);
}

TYPED_TEST(LazyTable, PlanesAreThoseOfTheLayoutOnceAskedFor) {
    const Polyhedron body = *stored_body<TypeParam>(*scene::make_shape("sphere38"));
    const TypeParam eager(body, Parts::features);
    const LazyLayout<TypeParam> lazy(body, Parts::features);
    EXPECT_EQ(lazy.made(), 0U);
    for (Index e = 0; e < body.edge_count(); ++e) {
        for (const End end : {End::tail, End::head})
            expect_same_plane(lazy.vertex_edge_plane(e, end), eager.vertex_edge_plane(e, end));
        for (const Side side : {Side::left, Side::right})
            expect_same_plane(lazy.edge_face_plane(e, side), eager.edge_face_plane(e, side));
        EXPECT_EQ(lazy.direction(e), eager.direction(e));
        EXPECT_EQ(lazy.made(), e + 1);
    }
    EXPECT_EQ(lazy.materialised(), 1);
}

TYPED_TEST(LazyTable, AnswersAreThoseOfTheLayoutAndFewEdgesAreMade) {
    const Polyhedron body = *stored_body<TypeParam>(*scene::make_shape("sphere386"));
    const TypeParam eager(body, Parts::features);
    using Made = LazyLayout<TypeParam>;
    const Made lazy(body, Parts::features);
    scene::Rng rng(3);
    Transform<double> pose;
    pose.rotation = rng.rotation();
    FeaturePair<TypeParam, TypeParam> warm_eager(eager, eager);
    FeaturePair<Made, Made> warm_lazy(lazy, lazy);
    for (int i = 0; i < 200; ++i) {
        pose.translation = Vec3d(2.5, 0, 0) + 0.01 * i * Vec3d(0, 1, 0.5);
        const Distance a = VClip::query(eager, eager, pose, warm_eager);
        const Distance b = VClip::query(lazy, lazy, pose, warm_lazy);
        EXPECT_EQ(std::memcmp(&a.distance, &b.distance, sizeof(double)), 0);
        EXPECT_EQ(a.point_a, b.point_a);
        EXPECT_EQ(a.steps, b.steps);
    }
    std::printf("%s: %zu of %zu edges made, %.3f of the table\n", std::string(TypeParam::name).c_str(),
                lazy.made(), body.edge_count(), lazy.materialised());
    EXPECT_GT(lazy.made(), 10U);
    EXPECT_LT(lazy.made(), body.edge_count() / 2);
    EXPECT_GT(lazy.materialised(), 0.1);
    EXPECT_LT(lazy.materialised(), 0.7);
}

TYPED_TEST(LazyTable, RefitMakesEverythingAgain) {
    const Polyhedron body = *stored_body<TypeParam>(*scene::make_shape("cube8"));
    const Polyhedron larger = scene::scaled(body, 2);
    LazyLayout<TypeParam> lazy(body, Parts::features);
    static_cast<void>(lazy.direction(0));
    refit(lazy, larger);
    EXPECT_EQ(lazy.made(), 0U);
    const TypeParam eager(larger, Parts::features);
    for (Index e = 0; e < body.edge_count(); ++e)
        expect_same_plane(lazy.edge_face_plane(e, Side::left), eager.edge_face_plane(e, Side::left));
}

/// Pages with only planes that no query asked for are not resident.
TEST(Lazy, TouchesNoPageOfPlanesThatNobodyAskedFor) {
    const Polyhedron body = *scene::make_shape("sphere1538");
    bench::Arena arena;
    const TablesIn placed(arena);
    const lazy<f64> table(body, Parts::features);
    const std::size_t planes = table.ledger()[Component::voronoi_planes];
    EXPECT_LT(*arena.resident(), table.ledger().total() - planes + 3 * 4096);
    for (Index e = 0; e < body.edge_count(); ++e) static_cast<void>(table.direction(e));
    EXPECT_GE(*arena.resident(), table.ledger().total());
}

}  // namespace
}  // namespace edgewise
