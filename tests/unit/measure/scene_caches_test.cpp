// SPDX-License-Identifier: MIT
//
// Synthetic traces with known misses and known causes of each miss.
#include "edgewise/measure/cache/scene_caches.hpp"

#include <gtest/gtest.h>

#include <random>

#include "edgewise/measure/cache/heat_map.hpp"

namespace edgewise::measure {
namespace {

/// 8 sets of 2 ways of 64 bytes over one of 64 ways; a TLB of 4 pages.
CacheMachine small_machine() {
    CacheMachine machine;
    machine.name = "small";
    machine.clock_mhz = 1000;
    machine.caches = {64, {{"L1", 8, 2}, {"L2", 1, 64}}};
    machine.origins = {{3, "made up", {}}, {10, "made up", {}}};
    machine.memory = {100, "made up", {}};
    machine.tlbs = {4096, {{"TLB", 1, 4}}};
    machine.tlb_origins = {{0, "made up", {}}};
    return machine;
}

TracedAccess read_of(std::uint64_t address, std::uint32_t bytes = 8, std::uint8_t field = 0,
                     std::uint8_t step = 0) {
    return {address, bytes, AccessKind::read, field, step, TraceSide::table_a};
}

/// Traces one query that reads the first bytes of each line in `lines`.
void ask(SceneCaches& caches, const std::vector<std::uint64_t>& lines, std::uint8_t field = 0) {
    for (const std::uint64_t line : lines) caches.on_access(read_of(line * 64, 8, field, field));
    caches.on_query_end(true);
}

TEST(SceneCaches, TellWhyALineWasMissed) {
    const CacheMachine machine = small_machine();
    SceneCaches caches({&machine, 1}, 2, 2);
    // Three lines of one set: with 16 lines in all, only the set is too small.
    for (int i = 0; i < 10; ++i) ask(caches, {0, 8, 16}, 0);
    const MissKinds one_set = caches.steady()[0].all.caches[0].misses;
    EXPECT_EQ(one_set.compulsory, 3U);
    EXPECT_EQ(one_set.capacity, 0U);
    EXPECT_EQ(one_set.conflict, 27U);
    // Three lines a set, one after the other: no cache of sixteen would do.
    std::vector<std::uint64_t> row;
    for (std::uint64_t line = 32; line < 56; ++line) row.push_back(line);
    for (int i = 0; i < 10; ++i) ask(caches, row, 1);
    const MachineMisses all = caches.steady()[0].all;
    EXPECT_EQ(all.caches[0].misses.compulsory, 27U);
    EXPECT_EQ(all.caches[0].misses.capacity, 216U);
    EXPECT_EQ(all.caches[0].misses.conflict, 27U);
    EXPECT_EQ(all.caches[0].by_field, (std::vector<std::uint64_t>{30, 240}));
    EXPECT_EQ(all.caches[0].by_step, (std::vector<std::uint64_t>{30, 240}));
    // The second level keeps all of them; its misses are those that nothing avoids.
    EXPECT_EQ(all.caches[1].misses.all(), 27U);
    EXPECT_EQ(all.caches[1].accesses, 270U);
    EXPECT_EQ(all.memory_ns, 243 * 10 + 27 * 100);
    EXPECT_TRUE(all.proved);
}

TEST(SceneCaches, ASecondPassFindsWhatTheFirstLeft) {
    const CacheMachine machine = small_machine();
    SceneCaches caches({&machine, 1}, 1, 1);
    ask(caches, {1, 2, 3});
    caches.start_steady();
    EXPECT_EQ(caches.queries().all, 0U);
    ask(caches, {1, 2, 3});
    EXPECT_EQ(caches.first()[0].caches[0].misses.compulsory, 3U);
    EXPECT_EQ(caches.first()[0].caches[1].misses.compulsory, 3U);
    EXPECT_EQ(caches.steady()[0].all.caches[0].accesses, 3U);
    EXPECT_EQ(caches.steady()[0].all.caches[0].misses.all(), 0U);
    EXPECT_EQ(caches.lines().steady.all.uses(), 3U);
    EXPECT_EQ(caches.lines().steady.all.firsts(), 0U);
    EXPECT_EQ(caches.lines().distinct, 3U);
    EXPECT_EQ(caches.queries().all, 1U);
}

/// Every line that a pass fetches counts as one miss, regardless of the line that it replaces.
TEST(SceneCaches, BringInALineForEachMiss) {
    const CacheMachine machine = small_machine();
    SceneCaches caches({&machine, 1}, 1, 1);
    ask(caches, {1, 2, 3});
    caches.start_steady();
    ask(caches, {1, 2, 3});
    EXPECT_EQ(caches.steady()[0].all.fetched.bytes, 0U) << "all was there";
    EXPECT_EQ(caches.steady()[0].all.fetched.unused, 0U);
    std::vector<std::uint64_t> many;
    for (std::uint64_t line = 0; line < 48; ++line) many.push_back(line);
    ask(caches, many);
    ask(caches, many);
    const MachineMisses steady = caches.steady()[0].all;
    EXPECT_EQ(steady.fetched.bytes, 64 * steady.caches[0].misses.all());
    EXPECT_EQ(steady.fetched.unused, 56 * steady.caches[0].misses.all()) << "eight bytes of each are used";
}

/// Empty caches before each query: its distinct lines, or more where a set is too small for them.
TEST(ColdCaches, MissEveryQuerysOwnLines) {
    const CacheMachine machine = small_machine();
    ColdCaches cold({&machine, 1});
    const auto ask_cold = [&](const std::vector<std::uint64_t>& lines) {
        for (const std::uint64_t line : lines) cold.on_access(read_of(line * 64));
        cold.on_query_end(true);
    };
    ask_cold({1, 2, 3, 1, 2, 3});
    ask_cold({1, 2, 3});
    EXPECT_EQ(cold.misses(0).all, (std::vector<std::uint64_t>{6, 6}));
    ask_cold(
        {0, 8, 16, 0, 8, 16});  // one set of two ways: six misses of the first level, three of the second
    EXPECT_EQ(cold.misses(0).all, (std::vector<std::uint64_t>{12, 9}));
    cold.on_access({0, 8, AccessKind::read, 0, 0, TraceSide::scene});
    EXPECT_EQ(cold.misses(0).all[0], 12U) << "tables alone";
}

TEST(SceneCaches, CountLinesPagesAndBytes) {
    const CacheMachine machine = small_machine();
    SceneCaches caches({&machine, 1}, 3, 1, true);
    HeatMap heat(3, 1);
    TraceFanOut both({&caches, &heat});
    both.on_access(read_of(60, 8));        // two lines
    both.on_access(read_of(4090, 12, 2));  // two lines and two pages
    both.on_access({64, 8, AccessKind::write, 1, 0, TraceSide::table_b});
    both.on_query_end(false);
    both.on_access(read_of(60, 4));
    both.on_access({8192, 8, AccessKind::write, 1, 0, TraceSide::scene});
    both.on_query_end(true);
    both.on_frame_end();
    EXPECT_EQ(caches.frames(), 1U);
    EXPECT_EQ(caches.lines().touched.all, 4 + 1U) << "the scene's own memory is no table's";
    EXPECT_EQ(caches.pages().touched.all, 2 + 1U);
    EXPECT_EQ(caches.pages().distinct, 3U);
    EXPECT_EQ(caches.pages().of_tables, 2U);
    EXPECT_EQ(caches.lines().in_frames, 5U);
    EXPECT_EQ(heat.touched().count(), 12 + 12 + 8U);
    EXPECT_EQ(heat.touched().count(64, 100), 8U);
    EXPECT_EQ(heat.touched().count(1 << 20, 100), 0U);
    EXPECT_EQ(heat.accesses_by_field().all, (std::vector<std::uint64_t>{2, 2, 1}));
    EXPECT_EQ(heat.queries().all, 2U);
    EXPECT_EQ(heat.lines(), 5U);
    EXPECT_EQ(heat.lines_taking(0.5), 2U) << "two lines of two accesses of seven";
    EXPECT_EQ(caches.steady()[0].all.tlbs[0].misses.compulsory, 3U);
    EXPECT_EQ(caches.steady()[0].all.caches[0].accesses, 7U);
    EXPECT_EQ(caches.steady()[0].all.fetched.bytes, 5 * 64U);
    caches.on_access(read_of(16384, 8));
    EXPECT_EQ(caches.lines().in_frames, 5U) << "a frame that has not ended does not count";
    caches.start_steady();
    caches.on_access(read_of(16384, 8));
    caches.on_frame_end();
    EXPECT_EQ(caches.lines().in_frames, 1U) << "nor does it in the steady pass";
}

/// Four lines of one way each: a cold query brings in what a warm one then finds, and the other way round.
/// Each is booked for itself, in the same caches; what lies between queries is all's alone.
TEST(SceneCaches, BookColdAndWarmQueriesApart) {
    const CacheMachine machine = small_machine();
    SceneCaches caches({&machine, 1}, 1, 1);
    ColdCaches emptied({&machine, 1});
    HeatMap heat(1, 1);
    TraceFanOut every({&caches, &emptied, &heat});
    const auto ask_from = [&](QueryStart start, const std::vector<std::uint64_t>& lines) {
        every.on_query_start(start);
        for (const std::uint64_t line : lines) every.on_access(read_of(line * 64));
        every.on_query_end(start == QueryStart::warm);
    };
    ask_from(QueryStart::cold, {1, 2, 3, 4, 1});
    ask_from(QueryStart::warm, {1, 2});
    ask_from(QueryStart::warm, {1, 5});
    every.on_access({6 * 64, 8, AccessKind::read, 0, 0, TraceSide::scene});
    const ByStart<MachineMisses> found = caches.steady()[0];
    EXPECT_EQ(found.cold.caches[0].misses.all(), 4U);
    EXPECT_EQ(found.warm.caches[0].misses.all(), 1U) << "the cold query brought in the others";
    EXPECT_EQ(found.all.caches[0].misses.all(), 6U);
    EXPECT_EQ(found.cold.caches[0].accesses, 5U);
    EXPECT_EQ(found.warm.caches[0].accesses, 4U);
    EXPECT_EQ(found.warm.caches[1].accesses, 1U);
    EXPECT_EQ(found.cold.memory_ns, 4 * 100);
    EXPECT_EQ(found.warm.memory_ns, 1 * 100);
    EXPECT_EQ(caches.queries().cold, 1U);
    EXPECT_EQ(caches.queries().warm, 2U);
    EXPECT_EQ(caches.lines().touched.cold, 4U);
    EXPECT_EQ(caches.lines().touched.warm, 4U);
    EXPECT_EQ(caches.lines().steady.cold.firsts(), 4U);
    EXPECT_EQ(caches.lines().steady.warm.firsts(), 1U);
    EXPECT_EQ(caches.lines().steady.warm.uses(), 4U);
    EXPECT_EQ(caches.lines().steady.all.uses(), 10U);
    EXPECT_EQ(emptied.misses(0).cold, (std::vector<std::uint64_t>{4, 4}));
    EXPECT_EQ(emptied.misses(0).warm, (std::vector<std::uint64_t>{4, 4})) << "emptied before each";
    EXPECT_EQ(heat.lines_of_queries().cold, 4U);
    EXPECT_EQ(heat.lines_of_queries().warm, 4U);
    EXPECT_EQ(heat.accesses_by_field().cold, (std::vector<std::uint64_t>{5}));
    EXPECT_EQ(heat.accesses_by_field().warm, (std::vector<std::uint64_t>{4}));
}

/// Every machine at once gives what each gives alone, whatever its lines.
TEST(SceneCaches, AreTheModelsOfEachMachine) {
    const auto machines = cache_machines();
    SceneCaches together(machines, 1, 1);
    std::mt19937_64 bits(1);
    std::vector<TracedAccess> trace;
    for (int i = 0; i < 50000; ++i)
        trace.push_back(read_of(bits() % (1 << (10 + bits() % 12)), 1 + bits() % 32));
    for (const TracedAccess& access : trace) together.on_access(access);
    const auto all = together.steady();
    for (std::size_t m = 0; m < machines.size(); ++m) {
        SCOPED_TRACE(machines[m].name);
        CacheModel alone(machines[m].caches), tlb(machines[m].tlbs);
        for (const TracedAccess& access : trace) {
            alone.access(access.address, access.bytes, access.kind);
            tlb.access(access.address, access.bytes, access.kind);
        }
        for (std::size_t level = 0; level < alone.counts().size(); ++level) {
            EXPECT_EQ(all[m].all.caches[level].misses.all(), alone.counts(level).misses);
            EXPECT_EQ(all[m].all.caches[level].accesses, alone.counts(level).accesses);
        }
        EXPECT_EQ(all[m].all.tlbs[0].misses.all(), tlb.counts(0).misses);
        EXPECT_GT(alone.counts(0).misses, 1000U);
    }
}

}  // namespace
}  // namespace edgewise::measure
