// SPDX-License-Identifier: MIT
//
// A query's walk next to the same query asked again: on the layout's own table with an observer of its
// features, and in a trace of its own that knows nothing of walks.
#include "edgewise/bench/trace/walk.hpp"

#include <gtest/gtest.h>

#include <iostream>

#include "edgewise/algorithms/vclip.hpp"
#include "edgewise/bench/name_answer.hpp"
#include "edgewise/layouts/aos.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::bench {
namespace {

using Lines = std::set<std::uint64_t>;

/// Lines of each step of one query, from the addresses alone.
class StepLines final : public measure::TraceListener {
  public:
    explicit StepLines(std::size_t query) : query_(query) {}
    void on_query_start(measure::QueryStart /*start*/) override { ++queries_; }
    void on_step_start(std::uint8_t step) override {
        if (queries_ == query_ + 1) steps.push_back({static_cast<TraceStep>(step), {}});
    }
    void on_access(const measure::TracedAccess& access) override {
        if (queries_ != query_ + 1 || access.side == measure::TraceSide::scene) return;
        for (std::uint64_t byte = 0; byte < access.bytes; ++byte)
            steps.back().second.insert((access.address + byte) / 64);
    }
    void on_query_end(bool /*counts*/) override {}

    std::vector<std::pair<TraceStep, Lines>> steps;

  private:
    std::size_t query_, queries_ = 0;
};

/// Notes the vertices of both features, from a table of the layout `aos`.
struct Watcher {
    const vclip::Body<aos<f64>>&a, &b;
    std::vector<std::vector<Index>>& on_a;
    std::vector<std::vector<Index>>& on_b;

    static std::vector<Index> corners(const vclip::Body<aos<f64>>& body) {
        if (body.feature.kind() == FeatureKind::vertex) return {body.feature.vertex()};
        if (body.feature.kind() == FeatureKind::edge)
            return {body.table.tail(body.feature.edge()), body.table.head(body.feature.edge())};
        std::vector<Index> ring;
        for (const auto [edge, flipped] : body.table.ring_of_face(body.feature.face()))
            ring.push_back(flipped ? body.table.head(edge) : body.table.tail(edge));
        return ring;
    }
    void visit(FeatureKind, FeatureKind) const {
        on_a.push_back(corners(a));
        on_b.push_back(corners(b));
    }
    static void ask_gjk() { FAIL() << "V-Clip walks to the end"; }
};

std::optional<Walk> walk_in(const studies::SingleCell& cell, std::size_t within) {
    const std::vector<TableMap> maps = cell.runner().memory_maps();
    WalkTrace trace(cell.algorithm(), cell.runner().stored_bodies(), cell.workload(), within);
    static_cast<void>(cell.runner().trace(within, trace));
    return trace.walk(maps);
}

/// Corners of two lists of vertices, without order: where a ring starts depends on the table.
std::set<Index> as_set(const std::vector<Index>& vertices) { return {vertices.begin(), vertices.end()}; }

TEST(Walk, HasTheFeaturesThatVClipVisitsOnTheLayoutItself) {
    for (const char* scene : {"tumble", "cold"}) {
        const studies::SingleCell cell({"aos_f64", "vclip", scene, "sphere386", {}, 200, 3});
        const auto walk = walk_in(cell, 200);
        ASSERT_TRUE(walk) << scene;
        const scene::Query& query = cell.workload().queries[walk->query];
        const auto bodies = cell.runner().stored_bodies();
        const aos<f64> table_a(bodies[query.body_a], Parts::features),
            table_b(bodies[query.body_b], Parts::features);
        const Transform<double> into_a = relative_pose(query.pose_a, query.pose_b), into_b = into_a.inverse();
        const auto start = Features<aos<f64>, aos<f64>>::first_of(table_a, table_b);
        vclip::Body<aos<f64>> a{table_a, into_a, start.a}, b{table_b, into_b, start.b};
        std::vector<std::vector<Index>> on_a, on_b;
        Watcher watcher{a, b, on_a, on_b};
        FirstTry first = FirstTry::walk;
        static_cast<void>(vclip::answer_from(a, b, watcher, true, first));
        ASSERT_EQ(walk->steps.size(), on_a.size() + 1) << "the search for a start, then the states";
        ASSERT_GE(on_a.size(), 4U);
        for (std::size_t i = 0; i < on_a.size(); ++i) {
            EXPECT_EQ(as_set(walk->steps[i + 1].a), as_set(on_a[i])) << scene << ", state " << i;
            EXPECT_EQ(as_set(walk->steps[i + 1].b), as_set(on_b[i])) << scene << ", state " << i;
        }
    }
}

/// All layouts take the same steps, read their own lines, and end at the features of the answer.
TEST(Walk, HasTheLinesOfTheTraceAndTheFeaturesOfTheAnswer) {
    std::size_t lines = 0;
    for (const char* scene : {"tumble", "pressure"}) {
        for (const char* algorithm : {"vclip", "gjk"}) {
            std::optional<Walk> first;
            for (const std::string table : {"aos_f64", "lean_f64", "lean_seeds_f64", "points_soa_f64"}) {
                const TableType* type = find_table_type(table);
                if (!type || !type->serves(algorithm)) continue;
                const std::string name = std::string(scene) + ", " + algorithm + ", " + table;
                const studies::SingleCell cell(
                    {table, algorithm, scene, "sphere386", {{"bodies", 12}}, 200, 3});
                const auto walk = walk_in(cell, 200);
                ASSERT_TRUE(walk) << name;
                if (!first) first = walk;
                EXPECT_EQ(walk->query, first->query) << name;
                EXPECT_EQ(walk->tables.size(), scene == std::string("pressure") ? 2U : 1U) << name;
                StepLines again(walk->query);
                static_cast<void>(cell.runner().trace(200, again));
                ASSERT_EQ(walk->steps.size(), again.steps.size()) << name;
                for (std::size_t i = 0; i < walk->steps.size(); ++i) {
                    EXPECT_EQ(walk->steps[i].state, again.steps[i].first) << name;
                    EXPECT_EQ(walk->steps[i].a, first->steps[i].a) << name;
                    EXPECT_EQ(walk->steps[i].lines.size(), again.steps[i].second.size()) << name;
                    if (walk->tables.size() == 1) {
                        EXPECT_EQ(walk->steps[i].lines, again.steps[i].second) << name;
                    }
                    lines += walk->steps[i].lines.size();
                }
                const Polyhedron& body = cell.runner().stored_bodies()[0];
                const auto answer = cell.runner().answer(cell.workload().queries[walk->query]);
                std::set<Index> named, ended;
                for (const Index v : answer.feature_a.vertices) named.insert(v);
                for (const Index v : walk->steps.back().a) ended.insert(body.input_index[v]);
                EXPECT_EQ(named, ended) << name;
            }
        }
    }
    EXPECT_GT(lines, 300U);
    std::cout << lines << " lines\n";
}

TEST(Walk, SmallBodiesAreSearchedInOneStepOfGjk) {
    const studies::SingleCell cell({"aos_f64", "gjk", "cold", "sphere38", {}, 50, 3});
    const auto walk = walk_in(cell, 50);
    ASSERT_TRUE(walk);
    ASSERT_EQ(walk->steps.size(), 1U) << "nothing is read before the search";
    EXPECT_GT(walk->steps[0].lines.size(), 10U) << "which reads all vertices";
    EXPECT_FALSE(walk->steps[0].a.empty());
}

TEST(Walk, IsNoneWhereTheTraceTakesOtherStepsOrTooFewQueries) {
    const studies::SingleCell vclip({"aos_f64", "vclip", "cold", "sphere386", {}, 50, 3});
    const auto bodies = vclip.runner().stored_bodies();
    const std::vector<TableMap> maps = vclip.runner().memory_maps();
    WalkTrace other("gjk", bodies, vclip.workload(), 50), early("vclip", bodies, vclip.workload(), 50),
        nothing("vclip", bodies, vclip.workload(), 0);
    for (WalkTrace* trace : {&other, &nothing}) static_cast<void>(vclip.runner().trace(50, *trace));
    EXPECT_FALSE(other.walk(maps));
    EXPECT_FALSE(early.walk(maps)) << "nothing was traced";
    EXPECT_FALSE(nothing.walk(maps));
}

}  // namespace
}  // namespace edgewise::bench
