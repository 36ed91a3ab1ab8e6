// SPDX-License-Identifier: MIT
//
// Compares stack distances with those of a plain list, and their miss curve with simulated caches.
#include "edgewise/measure/cache/reuse_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "edgewise/measure/cache/cache_model.hpp"

namespace edgewise::measure {
namespace {

/// Random lines: near ones often, far ones now and then, with stretches on one line.
std::vector<std::uint64_t> random_lines(std::size_t count, std::uint64_t seed) {
    std::mt19937_64 bits(seed);
    std::vector<std::uint64_t> lines;
    while (lines.size() < count) {
        const std::uint64_t range = std::uint64_t{4} << bits() % 9;
        const std::uint64_t line = bits() % range;
        for (std::uint64_t n = bits() % 8 == 0 ? 3 : 1; n > 0; --n) lines.push_back(line);
    }
    lines.resize(count);
    return lines;
}

TEST(ReuseDistance, OfAWordByHand) {
    ReuseDistance reuse;
    const std::uint64_t lines[] = {0, 1, 2, 0, 0, 2, 1, 3, 0};
    const std::uint64_t never = ReuseDistance::never,
                        expected[] = {never, never, never, 2, 0, 1, 2, never, 3};
    for (std::size_t i = 0; i < std::size(lines); ++i) EXPECT_EQ(reuse.use(lines[i]), expected[i]) << i;
    EXPECT_EQ(reuse.lines(), 4U);
    EXPECT_EQ(reuse.curve().uses(), 9U);
    EXPECT_EQ(reuse.curve().misses(0), 9U);
    EXPECT_EQ(reuse.curve().misses(1), 8U);
    EXPECT_EQ(reuse.curve().misses(3), 5U);
    EXPECT_EQ(reuse.curve().misses(4), 4U);
    EXPECT_EQ(reuse.curve().misses(1000), 4U);
    EXPECT_EQ(reuse.curve().smallest_size(0), 4U);
    EXPECT_EQ(reuse.curve().smallest_size(1), 3U);
    EXPECT_EQ(reuse.curve().smallest_size(100), 0U);
}

/// Long enough that time is renumbered several times.
TEST(ReuseDistance, IsThePlaceInAListOfLastUses) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        ReuseDistance reuse;
        std::vector<std::uint64_t> list;  // last used at the end
        for (const std::uint64_t line : random_lines(300000, seed)) {
            const auto found = std::find(list.rbegin(), list.rend(), line);
            const std::uint64_t expected = found == list.rend()
                                               ? ReuseDistance::never
                                               : static_cast<std::uint64_t>(found - list.rbegin());
            ASSERT_EQ(reuse.use(line), expected);
            if (found != list.rend()) list.erase(std::next(found).base());
            list.push_back(line);
        }
        EXPECT_EQ(reuse.lines(), list.size());
    }
}

TEST(MissCurve, IsAFullyAssociativeCacheAtEverySize) {
    ReuseDistance reuse;
    const auto lines = random_lines(100000, 4);
    for (const std::uint64_t line : lines) reuse.use(line);
    std::uint64_t last = 0;
    for (std::uint32_t size = 1; size <= 20; ++size) {
        const std::uint32_t ways = size * size * 2;
        CacheModel cache({64, {{"", 1, ways}}});
        for (const std::uint64_t line : lines) cache.access(line * 64, 1, AccessKind::read);
        EXPECT_EQ(cache.counts(0).misses, reuse.curve().misses(ways)) << ways;
        EXPECT_NE(cache.counts(0).misses, last) << "this size and the last have equal misses";
        last = cache.counts(0).misses;
    }
}

/// One stack a set gives every number of ways (Mattson's "all associativity").
TEST(MissCurve, OfEachSetIsTheSetAssociativeCache) {
    const auto lines = random_lines(100000, 5);
    for (const std::uint32_t sets : {4U, 12U}) {
        std::vector<ReuseDistance> stacks(sets);
        for (const std::uint64_t line : lines) stacks[line % sets].use(line / sets);
        for (const std::uint32_t ways : {1U, 2U, 3U, 8U, 12U}) {
            CacheModel cache({64, {{"", sets, ways}}});
            for (const std::uint64_t line : lines) cache.access(line * 64, 1, AccessKind::read);
            std::uint64_t misses = 0;
            for (const ReuseDistance& stack : stacks) misses += stack.curve().misses(ways);
            EXPECT_EQ(cache.counts(0).misses, misses) << sets << " sets, " << ways << " ways";
        }
    }
}

TEST(MissCurve, PointsAreOnTheCurveAndSpreadOverIt) {
    ReuseDistance reuse;
    for (const std::uint64_t line : random_lines(100000, 6)) reuse.use(line);
    const auto all = reuse.curve().points(100000), some = reuse.curve().points(16);
    EXPECT_GT(all.size(), 400U);
    EXPECT_LE(some.size(), 16U);
    EXPECT_GE(some.size(), 10U);
    for (const auto& [lines, misses] : some) EXPECT_EQ(misses, reuse.curve().misses(lines)) << lines;
    for (const auto& [lines, misses] : all) EXPECT_EQ(misses, reuse.curve().misses(lines)) << lines;
    EXPECT_EQ(some.back().lines, all.back().lines);
    EXPECT_EQ(some.back().misses, reuse.curve().firsts());
}

/// 100 queries of ten lines each, every line again after 50 others.
TEST(Knee, IsWhereQueriesFindWhatTheyComeBackTo) {
    ReuseDistance reuse;
    for (std::uint64_t query = 0; query < 100; ++query) {
        for (std::uint64_t i = 0; i < 10; ++i) reuse.use(query % 5 * 10 + i);
    }
    EXPECT_EQ(knee(reuse.curve(), 1000), 50U);
}

}  // namespace
}  // namespace edgewise::measure
