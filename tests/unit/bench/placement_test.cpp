// SPDX-License-Identifier: MIT
//
// How tables are placed changes what they cost and nothing else: every allocator, shared or a copy each,
// gives the plain answers, bit by bit; another order of vertices gives the same distances to rounding.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "edgewise/bench/registry.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/scene/scenes.hpp"
#include "edgewise/scene/shapes.hpp"

namespace edgewise::bench {
namespace {

const scene::Workload& tumble() {
    static const scene::Workload workload =
        *scene::make_scene("tumble", *scene::make_shape("sphere38"),
                           *scene::complete_parameters("tumble", {{"bodies", 8}}), 1, 600, {});
    return workload;
}

struct Placed {
    std::vector<Distance> answers;
    MemoryUse memory;
    measure::LinesTouched touched;
};

Placed place(const TableType& type, const std::string& algorithm, const TableOptions& options) {
    const auto runner = type.make_runner(algorithm);
    runner->configure({.tables = options});
    EXPECT_EQ(runner->load(tumble()), "");
    measure::LineCounter lines;
    runner->trace(100, lines);
    return {runner->answer(), runner->memory(), lines.sums().warm};
}

class Placement : public ::testing::TestWithParam<const char*> {
  protected:
    [[nodiscard]] static const TableType& type() { return table_type_called(GetParam()); }
};

TEST_P(Placement, LeavesTheAnswersAsTheyAre) {
    for (const std::string& algorithm : type().algorithms) {
        const Placed plain = place(type(), algorithm, {});
        EXPECT_EQ(plain.memory.tables, 1U);
        EXPECT_GT(plain.touched.queries, 0U);
        EXPECT_GE(plain.touched.lines, 2 * plain.touched.queries) << "each query reads both tables";
        for (const AllocatorKind allocator :
             {AllocatorKind::arena, AllocatorKind::jemalloc, AllocatorKind::libc}) {
            if (allocator == AllocatorKind::jemalloc && !make_jemalloc()) continue;
            const Placed other =
                place(type(), algorithm, {VertexOrder::given, Sharing::per_instance, allocator});
            EXPECT_EQ(other.memory.tables, tumble().instances.size());
            EXPECT_EQ(other.memory.requested, 8 * plain.memory.requested);
            EXPECT_GE(other.memory.taken, other.memory.requested);
            EXPECT_EQ(other.touched.reads, plain.touched.reads);
            ASSERT_EQ(other.answers.size(), plain.answers.size());
            for (std::size_t i = 0; i < plain.answers.size(); ++i) {
                EXPECT_EQ(other.answers[i].distance, plain.answers[i].distance);
                EXPECT_EQ(other.answers[i].point_a, plain.answers[i].point_a);
                EXPECT_EQ(other.answers[i].steps, plain.answers[i].steps);
            }
        }
    }
}

TEST_P(Placement, AnotherOrderGivesTheSameDistances) {
    const double allowed = type().eps > 1e-10 ? 1e-5 : 1e-13;
    for (const std::string& algorithm : type().algorithms) {
        const Placed plain = place(type(), algorithm, {});
        for (const VertexOrder order : {VertexOrder::bfs, VertexOrder::spatial, VertexOrder::rcm}) {
            const Placed other = place(type(), algorithm, {order, Sharing::shared, AllocatorKind::arena});
            for (std::size_t i = 0; i < plain.answers.size(); ++i)
                EXPECT_NEAR(other.answers[i].distance, plain.answers[i].distance, allowed);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Placement, ::testing::Values("aos_f64", "lean_f32", "points_soa_f64"),
                         [](const auto& of) { return std::string(of.param); });

/// Building is timed as often as asked, and every layout of the family can be refitted.
TEST(BuildTimes, AreAsManyAsAsked) {
    const std::string all[] = {"all"};
    for (const TableType* type : select_table_types(all)) {
        const auto runner = type->make_runner(type->algorithms.front());
        const Polyhedron& sphere = tumble().bodies[0];
        const Polyhedron body = type->stored_body(sphere) ? sphere : scene::make_shape("cube8").or_throw();
        ASSERT_EQ(runner->load(std::vector{body}), "");
        const BuildTimes times = runner->build_times(3);
        EXPECT_EQ(times.build_ns.size(), 3U) << type->name;
        EXPECT_EQ(times.refit_ns.size(), 3U) << type->name;
    }
}

TEST(RelativeOrder, NamesFeaturesByTheUsersIndices) {
    const TableType* relative = find_table_type("lean_relative_f64");
    if (!relative) GTEST_SKIP() << "this program has not this one";
    // A corner of the cube to either side: the nearest are (1, 1, 1) of one and (-1, -1, -1) of the other.
    const Polyhedron cube = scene::make_shape("cube8").or_throw();
    const auto runner = relative->make_runner("vclip");
    ASSERT_EQ(runner->load(std::vector{cube}), "");
    scene::Query query{0, 0, 0, {}, {}};
    query.pose_b.translation = 4 * cube.vertices[7];
    const NamedAnswer answer = runner->answer(query);
    ASSERT_EQ(answer.feature_a.vertices.size(), 1U);
    EXPECT_EQ(answer.feature_a.vertices[0], cube.input_index[7]);
    const Vec3d opposite = -cube.vertices[7];
    ASSERT_EQ(answer.feature_b.vertices.size(), 1U);
    EXPECT_EQ(cube.vertices[answer.feature_b.vertices[0]], opposite);
}

}  // namespace

}  // namespace edgewise::bench
