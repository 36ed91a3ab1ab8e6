// SPDX-License-Identifier: MIT
//
// Lines per query three ways, of the same queries: as the probe `lines` counts them, as misses of a cache
// that holds everything and is emptied before each query, and as `edgewise draw heat` counts them. Tables are
// one for each body, so that no line is of both. They agree to the last line, of queries that start cold and
// warm.
#include <gtest/gtest.h>

#include <cstdio>

#include "edgewise/bench/trace/trace_names.hpp"
#include "edgewise/measure/cache/heat_map.hpp"
#include "edgewise/measure/cache/lines_touched.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"
#include "edgewise/studies/single_cell.hpp"

namespace edgewise::bench {
namespace {

studies::CellChoice followed(const char* algorithm, const char* shape, std::size_t queries = 3000) {
    return {"aos_f64",
            algorithm,
            "tumble",
            shape,
            {{"bodies", 100}, {"margin", 0}, {"in_time_order", 1}, {"rotation_step", 1.0 / 60}},
            queries,
            1};
}

/// One level of 2^21 lines, as good as endless.
measure::CacheMachine endless_machine() {
    measure::CacheMachine machine;
    machine.name = "endless";
    machine.clock_mhz = 1000;
    machine.caches = {64, {{"L1", 1 << 18, 8}}};
    machine.origins = {{1, "made up", {}}};
    machine.memory = {100, "made up", {}};
    return machine;
}

class Populations : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(Populations, HaveTheSameLinesThreeWays) {
    const auto& [algorithm, shape] = GetParam();
    const studies::SingleCell cell(followed(algorithm, shape), {.sharing = Sharing::per_instance});
    const measure::CacheMachine machine = endless_machine();
    measure::LineCounter lines;
    measure::ColdCaches emptied({&machine, 1});
    measure::SceneCaches caches({&machine, 1}, field_names().size(), step_names().size(), true);
    measure::HeatMap heat(field_names().size(), step_names().size());
    measure::TraceFanOut every({&lines, &emptied, &caches, &heat});
    const PassSum passed = cell.runner().trace(TraceExtent::everything(), every);
    for (const measure::QueryStart start : {measure::QueryStart::cold, measure::QueryStart::warm}) {
        const measure::LinesTouched& counted = lines.sums().of(start);
        SCOPED_TRACE(start == measure::QueryStart::cold ? "cold" : "warm");
        EXPECT_GT(counted.queries, 50U);
        EXPECT_EQ(emptied.misses(0).of(start).front(), counted.lines);
        EXPECT_EQ(caches.lines().touched.of(start), counted.lines);
        EXPECT_EQ(heat.lines_of_queries().of(start), counted.lines);
        EXPECT_EQ(caches.queries().of(start), counted.queries);
        EXPECT_EQ(heat.queries().of(start), counted.queries);
        std::printf("%s %s %s: %.2f lines per query\n", algorithm, shape,
                    start == measure::QueryStart::cold ? "cold" : "warm",
                    static_cast<double>(counted.lines) / static_cast<double>(counted.queries));
    }
    EXPECT_EQ(lines.sums().cold.lines + lines.sums().warm.lines, lines.sums().all.lines);
    EXPECT_EQ(lines.sums().all.queries, passed.queries);
    EXPECT_EQ(lines.sums().cold.queries, cell.workload().pair_count) << "each pair has one first query";
    const auto per_query = [&](measure::QueryStart start) {
        const measure::LinesTouched& of = lines.sums().of(start);
        return static_cast<double>(of.lines) / static_cast<double>(of.queries);
    };
    EXPECT_GT(per_query(measure::QueryStart::cold), per_query(measure::QueryStart::warm))
        << "a cold query takes a longer path";
}

INSTANTIATE_TEST_SUITE_P(Of, Populations,
                         testing::Combine(testing::Values("vclip", "gjk"),
                                          testing::Values("sphere38", "sphere386")),
                         [](const auto& of) {
                             return std::string(std::get<0>(of.param)) + "_" + std::get<1>(of.param);
                         });

/// A sampled trace follows every n-th pair through whole steps, from the first query of that pair, and skips
/// none of its queries. Each query reads the same data as in a trace of every pair.
TEST(TraceExtents, FollowAPairAsATraceOfEveryPairDoes) {
    const studies::SingleCell cell(followed("vclip", "sphere38", 6000));
    const TraceExtent sampled = sampled_extent(cell.workload(), 300);
    ASSERT_GT(sampled.pair_stride, 1U);
    std::vector<Distance> every(cell.workload().queries.size()), some(every.size());
    measure::LineCounter of_every, of_some;
    static_cast<void>(cell.runner().trace(TraceExtent::everything(), of_every, every.data()));
    const PassSum passed = cell.runner().trace(sampled, of_some, some.data());
    std::size_t followed_pairs = 0, last = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
        if (some[i].steps == 0) continue;
        EXPECT_EQ(cell.workload().queries[i].pair % sampled.pair_stride, 0U);
        EXPECT_EQ(some[i].steps, every[i].steps) << "query " << i;
        EXPECT_EQ(some[i].distance, every[i].distance);
        ++followed_pairs;
        last = i;
    }
    EXPECT_EQ(followed_pairs, passed.queries);
    EXPECT_GE(of_some.sums().warm.queries, 300U);
    ASSERT_GT(cell.workload().frames.size(), least_traced_steps);
    EXPECT_GE(last + sampled.pair_stride * 4, cell.workload().frames[least_traced_steps].first_query)
        << "fifty steps";
    EXPECT_LT(passed.queries, every.size());
}

TEST(TraceExtents, TakeWholeSteps) {
    const studies::SingleCell cell(followed("gjk", "sphere38"));
    measure::LineCounter lines;
    const auto& frames = cell.workload().frames;
    ASSERT_GT(frames.size(), 8U);
    EXPECT_EQ(cell.runner().trace({1, 7}, lines).queries, frames[7].first_query);
    measure::LineCounter more;
    const auto counted = frames[7].first_query;
    EXPECT_GT(cell.runner().trace({counted, 7}, more).queries, counted) << "cold ones do not count";
}

}  // namespace
}  // namespace edgewise::bench
