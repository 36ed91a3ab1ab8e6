// SPDX-License-Identifier: MIT
//
// A pair that is kept while a table is rebuilt with another topology: its handles mean nothing any more, and
// the next query answers as if it were the first.
#include <gtest/gtest.h>

#include <type_traits>
#include <utility>

#include "edgewise/algorithms/gjk.hpp"
#include "edgewise/algorithms/near_pair.hpp"
#include "edgewise/algorithms/penetration/start.hpp"
#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/layout_parts/write_geometry.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/layouts/lazy.hpp"
#include "edgewise/layouts/lean.hpp"
#include "edgewise/layouts/linked.hpp"
#include "edgewise/layouts/points_neighbours.hpp"
#include "edgewise/scene/rng.hpp"
#include "edgewise/scene/shapes.hpp"
#include "edgewise/table/canonical.hpp"
#include "edgewise/table/scaled_table.hpp"

namespace edgewise {
namespace {

void expect_same(const Distance& found, const Distance& fresh) {
    EXPECT_EQ(found.status, fresh.status);
    EXPECT_EQ(found.distance, fresh.distance);
    EXPECT_EQ(found.normal, fresh.normal);
    EXPECT_EQ(found.steps, fresh.steps) << "as cold as a new pair";
}

/// Bodies of more and of fewer features in turns, all in the same place in memory.
template <class Algorithm, class Table>
void keep_a_pair_over_rebuilds() {
    using TablePair = typename Algorithm::template Pair<Table, Table>;
    const Table other(*scene::make_shape("sphere18"), Parts::features);
    Table table(*scene::make_shape("sphere386"), Parts::features);
    TablePair kept(table, other);
    scene::Rng rng(1);
    for (int i = 0; i < 60; ++i) {
        const char* const shapes[] = {"tetra4", "sphere386", "cube8", "sphere38", "sphere18"};
        const Transform<double> pose{rng.rotation(), rng.uniform(0, 2.5) * rng.on_sphere()};
        static_cast<void>(Algorithm::query(table, other, pose, kept));
        table = Table(*scene::make_shape(shapes[i % 5]), Parts::features);
        EXPECT_FALSE(kept.belongs_to(table, other));
        EXPECT_EQ(simplex_of(table, other, kept).belongs_to(table, other) &&
                      simplex_of(table, other, kept).count() > 0,
                  false)
            << "no start for EPA either";
        TablePair fresh(table, other);
        expect_same(Algorithm::query(table, other, pose, kept), Algorithm::query(table, other, pose, fresh));
        EXPECT_TRUE(kept.belongs_to(table, other));
    }
}

// A temporary body, also that of a Result, would be gone before the first query.
using TemporaryBody = decltype(*std::declval<Result<Polyhedron>>());
static_assert(!std::is_constructible_v<lazy<f64>, TemporaryBody, Parts>);
static_assert(!std::is_constructible_v<Canonical, TemporaryBody>);
static_assert(std::is_constructible_v<lean<f64>, TemporaryBody, Parts>);

TEST(RebuiltTable, AnOldPairStartsCold) {
    keep_a_pair_over_rebuilds<Gjk, points_neighbours<f64>>();
    keep_a_pair_over_rebuilds<Gjk, lean<f32>>();
    keep_a_pair_over_rebuilds<VClip, lean<f64>>();
    keep_a_pair_over_rebuilds<VClip, aos<f64>>();
    keep_a_pair_over_rebuilds<VClip, linked<f64>>();
}

/// New geometry on the old topology leaves handles as they are, and views share them.
TEST(RebuiltTable, ARefittedTableKeepsItsPairs) {
    const Polyhedron body = *scene::make_shape("sphere38");
    aos<f64> table(body, Parts::features);
    FeaturePair<aos<f64>, aos<f64>> pair(table, table);
    write_geometry(table, scene::scaled(body, 1.5));
    EXPECT_TRUE(pair.belongs_to(table, table));
    const aos<f64, Direct> view(table, Direct{});
    EXPECT_TRUE(pair.belongs_to(view, table));
}

/// The sanitized build would see a read of the body's memory.
template <class Algorithm, class Table>
void outlive_the_body() {
    const Polyhedron kept = *scene::make_shape("sphere38");
    const Table known(kept, Parts::features);
    const auto make = [&kept] {
        const Polyhedron copy = kept;
        return Table(copy, Parts::features);
    };
    const Table table = make();
    scene::Rng rng(2);
    for (int i = 0; i < 20; ++i) {
        const Transform<double> pose{rng.rotation(), rng.uniform(0, 2.5) * rng.on_sphere()};
        typename Algorithm::template Pair<Table, Table> pair(table, known), fresh(known, known);
        expect_same(Algorithm::query(table, known, pose, pair), Algorithm::query(known, known, pose, fresh));
    }
}

TEST(RebuiltTable, ATableNeedsItsBodyNoMore) {
    outlive_the_body<Gjk, points_neighbours<f64>>();
    outlive_the_body<VClip, lean<f64>>();
    outlive_the_body<VClip, aos<f64>>();
    outlive_the_body<VClip, linked<f64>>();
}

// Classes that borrow a table or a body take no temporary.
using Aos = aos<f64>;
using Near = NearPair<VClip, Aos, Aos>;
static_assert(std::is_constructible_v<Near, Aos&, Aos&> && !std::is_constructible_v<Near, Aos&, Aos>);
static_assert(!std::is_constructible_v<ScaledTable<Aos>, Aos, Vec3d>);
static_assert(!std::is_constructible_v<Canonical, Polyhedron>);
static_assert(!std::is_constructible_v<lazy<f64>, Polyhedron, Parts>);

}  // namespace
}  // namespace edgewise
