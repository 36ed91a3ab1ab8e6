// SPDX-License-Identifier: MIT
//
// A cell's traced passes, from the scene to the figures: what must hold whatever the layout.
#include "edgewise/bench/trace/trace_scene.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <set>

#include "edgewise/bench/probe.hpp"
#include "edgewise/bench/trace/frame_trace.hpp"
#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::bench {
namespace {

studies::CellChoice in_time_order(const std::string& table, const std::string& algorithm) {
    return {table,
            algorithm,
            "tumble",
            "sphere38",
            {{"bodies", 40}, {"in_time_order", 1}, {"rotation_step", 0.3}},
            500,
            1};
}

std::vector<measure::MachineChoice> two_machines() {
    const std::string names[] = {"pentium3_coppermine", "zen5"};
    return measure::choose_machines(names);
}

class TraceScene : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(TraceScene, MissesWhatItMust) {
    const studies::SingleCell cell(in_time_order(GetParam().first, GetParam().second));
    const auto machines = two_machines();
    const measure::SceneTrace trace = trace_scene(cell.runner(), cell.workload(), {machines, 0});
    ASSERT_TRUE(trace.traced()) << trace.reason;
    EXPECT_EQ(trace.queries.all, cell.workload().queries.size());
    EXPECT_EQ(trace.frames, cell.workload().frames.size());
    ASSERT_EQ(trace.machines.size(), 2U);
    ASSERT_EQ(trace.policies.size(), 4U);
    EXPECT_EQ(trace.policies[0].name, "zen5/tree_plru");
    EXPECT_EQ(trace.policies[2].name, "zen5/next_line");
    EXPECT_LT(trace.policies[2].first.caches[0].misses.all(),
              trace.machines.back().first.caches[0].misses.all())
        << "tables are read in lines that follow each other";
    for (const measure::ModelledMachine& machine : trace.machines) {
        for (const measure::LevelMisses& level : machine.first.caches) {
            EXPECT_EQ(level.misses.compulsory, level.first_touches) << "the first pass starts empty";
            EXPECT_GT(level.first_touches, 0U);
        }
        for (const measure::LevelMisses& level : machine.steady.all.caches)
            EXPECT_EQ(level.misses.compulsory, 0U) << "the second pass touches what the first did";
        const measure::LevelMisses& first = machine.steady.all.caches.front();
        std::uint64_t by_field = 0, by_step = 0;
        for (const std::uint64_t count : first.by_field) by_field += count;
        for (const std::uint64_t count : first.by_step) by_step += count;
        EXPECT_EQ(by_field, first.misses.all());
        EXPECT_EQ(by_step, first.misses.all());
        EXPECT_LE(machine.steady.all.fetched.unused, machine.steady.all.fetched.bytes);
    }
    EXPECT_GE(trace.lines.in_frames, trace.lines.distinct) << "frames touch all that the scene does";
    EXPECT_LE(trace.lines.of_tables, trace.lines.distinct);
    std::printf("%s %s: %.1f lines per query, %llu of the scene\n", GetParam().first, GetParam().second,
                static_cast<double>(trace.lines.touched.all) / static_cast<double>(trace.queries.all),
                static_cast<unsigned long long>(trace.lines.distinct));
}

TEST_P(TraceScene, AnswersAsThePassThatIsChecked) {
    const studies::SingleCell cell(in_time_order(GetParam().first, GetParam().second));
    const auto machines = two_machines();
    const measure::SceneTrace trace = trace_scene(cell.runner(), cell.workload(), {machines, 0});
    const double cold = static_cast<double>(trace.machines[1].emptied.all.front());
    EXPECT_GE(cold, static_cast<double>(trace.lines.touched.all))
        << "a query from empty caches misses every line";
    EXPECT_LE(cold, 1.2 * static_cast<double>(trace.lines.touched.all));
    EXPECT_GE(trace.lines.with_scene.all, trace.lines.touched.all);
    double sum = 0;
    for (const Distance& answer : cell.runner().answer()) sum += answer.distance;
    EXPECT_EQ(trace.distances, sum) << "the traced pass gives the same answers";
    const PassSum passed = cell.runner().prepared_pass()();
    EXPECT_EQ(passed.distances, sum) << "so does the pass for counters";
    EXPECT_EQ(passed.queries, trace.answered);
}

TEST_P(TraceScene, BooksTheRightSteps) {
    const bool vclip = std::string(GetParam().second) == "vclip";
    const studies::SingleCell cell(in_time_order(GetParam().first, GetParam().second));
    const auto machines = two_machines();
    const measure::SceneTrace trace = trace_scene(cell.runner(), cell.workload(), {machines, 0});
    const auto steps = [&](TraceStep step) { return trace.heat.by_step[static_cast<std::size_t>(step)]; };
    for (const TraceStep state : {TraceStep::vertex_vertex, TraceStep::vertex_edge, TraceStep::vertex_face,
                                  TraceStep::edge_edge, TraceStep::edge_face})
        EXPECT_EQ(steps(state) > 0, vclip);
    EXPECT_EQ(steps(TraceStep::gjk_iteration) > 0, !vclip);
    EXPECT_EQ(steps(TraceStep::pair_cache), 2 * 2 * trace.queries.all) << "read and written, in both passes";
    EXPECT_GT(steps(TraceStep::broad_phase), 2 * 40 * trace.frames);
    EXPECT_GT(trace.heat.by_field.all[broad_phase_field], 0U);
}

INSTANTIATE_TEST_SUITE_P(Of, TraceScene,
                         testing::Values(std::pair{"aos_f64", "vclip"}, std::pair{"aos_f64", "gjk"},
                                         std::pair{"lean_f64", "vclip"}, std::pair{"aos_f32", "vclip"},
                                         std::pair{"quantised_f32", "gjk"}),
                         [](const auto& of) { return std::string(of.param.first) + "_" + of.param.second; });

TEST(TraceSceneFigures, AreThereForEveryMachineOrSayWhyNot) {
    const studies::SingleCell cell(in_time_order("aos_f64", "vclip"));
    std::vector<measure::MachineChoice> machines = two_machines();
    machines.push_back({"host", measure::Expected<measure::CacheMachine>::none("made up")});
    const ProbedCell probed{.type = cell.type(),
                            .algorithm = algorithm_called("vclip"),
                            .runner = cell.runner(),
                            .workload = cell.workload(),
                            .caches = {machines, 100}};
    std::set<std::string> names;
    for (const Probe& probe : registered_probes()) {
        if (!probe.beside_others) continue;
        for (const measure::Figure& figure : probe.measure(probed).figures) {
            EXPECT_TRUE(names.insert(figure.name).second) << figure.name << " twice";
            EXPECT_NE(figure.value.has_value(), !figure.reason.empty()) << figure.name;
            EXPECT_TRUE(!figure.name.ends_with("cold_verified") || figure.value == 1.0) << figure.name;
        }
    }
    for (const char* name :
         {"pentium3_coppermine.L2.misses_per_query", "pentium3_coppermine.L2.misses_per_query.warm",
          "pentium3_coppermine.L2.misses_per_query.cold", "line_knee_bytes.warm", "lines_per_query.cold",
          "zen5.L3.misses_per_query", "host.L1D.misses_per_query", "zen5/random.L1D.misses_per_query",
          "pentium3_coppermine.dTLB.misses_per_query", "line_knee_bytes", "page_knee_bytes", "lines_of_frame",
          "touched_part", "touched_vertices"})
        EXPECT_TRUE(names.count(name)) << name;
}

TEST(TraceSceneFigures, KnowWhatTheyAreOf) {
    const auto identity = [](std::span<const measure::MachineChoice> machines, std::size_t queries) {
        return CacheOrder{machines, queries}.identity();
    };
    const std::vector<measure::MachineChoice> two = two_machines();
    const std::vector<measure::MachineChoice> again = two_machines();
    EXPECT_EQ(identity(two, 100), identity(again, 100));
    EXPECT_NE(identity(two, 100), identity(two, 101));
    EXPECT_NE(identity(two, 100), identity(std::span(two).first(1), 100));
    EXPECT_NE((CacheOrder{two, 100, 50}.identity()), (CacheOrder{two, 100}.identity()));
    std::vector<measure::MachineChoice> other = two;
    ++other[1].machine.value->caches.levels[0].ways;
    EXPECT_NE(identity(two, 100), identity(other, 100));
}

TEST(TraceSceneFigures, NeedAddressesThatAreTheSameInEveryRun) {
    const studies::SingleCell cell(in_time_order("aos_f64", "vclip"),
                                   {VertexOrder::given, Sharing::shared, AllocatorKind::libc});
    const auto machines = two_machines();
    EXPECT_FALSE(trace_scene(cell.runner(), cell.workload(), {machines, 10}).traced());
}

TEST(TimeOrder, AsksTheSameQueriesAsPairAfterPair) {
    studies::CellChoice choice = in_time_order("aos_f64", "vclip");
    const studies::SingleCell in_time(choice);
    choice.parameters["in_time_order"] = 0;
    const studies::SingleCell by_pair(choice);
    std::multiset<std::tuple<std::uint32_t, double, double>> first, second;
    for (const auto& [cell, set] : {std::pair{&in_time, &first}, std::pair{&by_pair, &second}}) {
        for (const scene::Query& query : cell->workload().queries)
            set->insert({query.pair, query.pose_a.translation.x(), query.pose_b.translation.y()});
    }
    EXPECT_EQ(first, second);
    EXPECT_TRUE(by_pair.workload().frames.empty());
    EXPECT_GT(in_time.workload().frames.size(), 3U);
}

TEST(FrameTraces, FindTheScenesOwnPairs) {
    class Counter final : public measure::TraceListener {
      public:
        void on_access(const measure::TracedAccess&) override { ++accesses; }
        void on_query_end(bool) override {}
        std::size_t accesses = 0;
    };
    const studies::SingleCell cell(in_time_order("aos_f64", "vclip"));
    const scene::Workload& workload = cell.workload();
    Counter counter;
    const TracePlaces places(nullptr, 0, 8, workload.pair_count, workload.instances.size());
    FrameTrace broad_phase(workload, places, counter);
    for (std::size_t i = 0; i + 1 < workload.frames.size(); ++i) {
        const std::size_t pairs = workload.frames[i + 1].first_query - workload.frames[i].first_query;
        EXPECT_EQ(broad_phase.run(workload.frames[i]), pairs) << "frame " << i;
    }
    EXPECT_GT(counter.accesses, 40 * workload.frames.size());
}

}  // namespace
}  // namespace edgewise::bench
