// SPDX-License-Identifier: MIT
//
// Made-up traces whose misses, and why they were missed, are known.
#include "edgewise/measure/scene_caches.hpp"

#include <gtest/gtest.h>

#include <random>

namespace edgewise {
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
    return {address, bytes, AccessKind::read, field, step, 0};
}

/// One query that reads the first bytes of these lines.
void ask(SceneCaches& caches, const std::vector<std::uint64_t>& lines, std::uint8_t field = 0) {
    for (const std::uint64_t line : lines) caches.on_access(read_of(line * 64, 8, field, field));
    caches.on_query_end(true);
}

TEST(SceneCaches, TellWhyALineWasMissed) {
    const CacheMachine machine = small_machine();
    SceneCaches caches({&machine, 1}, 2, 2);
    // Three lines of one set: with 16 lines in all, only the set is too small.
    for (int i = 0; i < 10; ++i) ask(caches, {0, 8, 16}, 0);
    const MissKinds one_set = caches.steady()[0].caches[0].misses;
    EXPECT_EQ(one_set.compulsory, 3U);
    EXPECT_EQ(one_set.capacity, 0U);
    EXPECT_EQ(one_set.conflict, 27U);
    // Three lines a set, one after the other: no cache of sixteen would do.
    std::vector<std::uint64_t> row;
    for (std::uint64_t line = 32; line < 56; ++line) row.push_back(line);
    for (int i = 0; i < 10; ++i) ask(caches, row, 1);
    const MachineMisses all = caches.steady()[0];
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
    EXPECT_EQ(caches.queries(), 0U);
    ask(caches, {1, 2, 3});
    EXPECT_EQ(caches.first()[0].caches[0].misses.compulsory, 3U);
    EXPECT_EQ(caches.first()[0].caches[1].misses.compulsory, 3U);
    EXPECT_EQ(caches.steady()[0].caches[0].accesses, 3U);
    EXPECT_EQ(caches.steady()[0].caches[0].misses.all(), 0U);
    EXPECT_EQ(caches.lines().steady.uses(), 3U);
    EXPECT_EQ(caches.lines().steady.firsts(), 0U);
    EXPECT_EQ(caches.lines().distinct, 3U);
    EXPECT_EQ(caches.queries(), 1U);
}

TEST(SceneCaches, CountLinesPagesAndBytes) {
    const CacheMachine machine = small_machine();
    SceneCaches caches({&machine, 1}, 3, 1);
    caches.on_access(read_of(60, 8));        // two lines
    caches.on_access(read_of(4090, 12, 2));  // two lines and two pages
    caches.on_access({64, 8, AccessKind::write, 1, 0, 1});
    caches.on_query_end(false);
    EXPECT_EQ(caches.lines().touched, 4U);
    EXPECT_EQ(caches.pages().touched, 2U);
    EXPECT_EQ(caches.pages().distinct, 2U);
    EXPECT_EQ(caches.bytes_touched(), 12 + 12U);
    EXPECT_EQ(caches.accesses_by_field(), (std::vector<std::uint64_t>{1, 1, 1}));
    EXPECT_EQ(caches.steady()[0].tlbs[0].misses.compulsory, 2U);
    EXPECT_EQ(caches.steady()[0].caches[0].accesses, 5U);
    EXPECT_EQ(caches.steady()[0].fetched.bytes, 4 * 64U);
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
        for (std::size_t level = 0; level < alone.levels(); ++level) {
            EXPECT_EQ(all[m].caches[level].misses.all(), alone.counts(level).misses);
            EXPECT_EQ(all[m].caches[level].accesses, alone.counts(level).accesses);
        }
        EXPECT_EQ(all[m].tlbs[0].misses.all(), tlb.counts(0).misses);
        EXPECT_GT(alone.counts(0).misses, 1000U);
    }
}

}  // namespace
}  // namespace edgewise
