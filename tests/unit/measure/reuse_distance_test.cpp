// SPDX-License-Identifier: MIT
//
// Compares stack distances with those of a plain list, and their miss curve with simulated caches.
#include "edgewise/measure/cache/reuse_distance.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <random>
#include <set>

#include "edgewise/measure/cache/cache_model.hpp"
#include "edgewise/measure/cache/segmented_lru.hpp"
#include "edgewise/measure/process/fault_pager.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"

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

// The policy against plain lists that are searched; with one mapped page against exact reuse distances, with
// all mapped against a queue.

/// Pages 0 .. pages - 1, small ones more often.
std::vector<std::uint32_t> some_uses(std::uint64_t seed, std::size_t count, std::uint32_t pages) {
    scene::Rng rng(seed);
    std::vector<std::uint32_t> uses;
    for (std::size_t i = 0; i < count; ++i)
        uses.push_back(static_cast<std::uint32_t>(rng.uniform() * rng.uniform() * pages));
    return uses;
}

/// Reference for SegmentedLru: two queues of pages, newest first.
class PlainSegments {
  public:
    PlainSegments(std::size_t mapped, std::size_t held) : most_mapped_(mapped), held_(held) {}

    PageUse use(std::uint32_t page) {
        if (std::count(mapped_.begin(), mapped_.end(), page) > 0) return PageUse::mapped;
        const auto known = std::find(unmapped_.begin(), unmapped_.end(), page);
        const PageUse missed = used_.insert(page).second ? PageUse::first : PageUse::hard;
        const PageUse how = known == unmapped_.end() ? missed : PageUse::soft;
        if (how == PageUse::soft) unmapped_.erase(known);
        mapped_.push_front(page);
        if (mapped_.size() > most_mapped_) {
            unmapped_.push_front(mapped_.back());
            mapped_.pop_back();
        }
        if (mapped_.size() + unmapped_.size() > held_) unmapped_.pop_back();
        return how;
    }

  private:
    std::size_t most_mapped_, held_;
    std::deque<std::uint32_t> mapped_, unmapped_;
    std::set<std::uint32_t> used_;
};

TEST(SegmentedLru, IsThatOfPlainLists) {
    for (const auto& [mapped, held] : {std::pair{1U, 20U}, {5U, 20U}, {19U, 20U}, {20U, 20U}, {3U, 3U}}) {
        SegmentedLru memory(100, mapped, held);
        PlainSegments plain(mapped, held);
        std::size_t hard = 0, soft = 0;
        for (const std::uint32_t page : some_uses(7, 20000, 100)) {
            const PageUse how = memory.use(page).how;
            ASSERT_EQ(how, plain.use(page)) << mapped << " of " << held;
            ASSERT_LE(memory.held(), held);
            hard += how == PageUse::hard;
            soft += how == PageUse::soft;
        }
        EXPECT_GT(hard, 1000U);
        EXPECT_EQ(soft > 0, mapped < held);
    }
}

TEST(SegmentedLru, IsLruWithOnePageMapped) {
    for (const std::size_t held : {2U, 10U, 50U}) {
        SegmentedLru memory(200, 1, held);
        ReuseDistance reuse;
        for (const std::uint32_t page : some_uses(11, 20000, 200)) {
            const std::uint64_t distance = reuse.use(page);
            const PageUse how = memory.use(page).how;
            ASSERT_EQ(how == PageUse::first, distance == ReuseDistance::never);
            ASSERT_EQ(how == PageUse::hard, distance != ReuseDistance::never && distance >= held);
        }
    }
}

TEST(SegmentedLru, TellsWhichPageIsMappedNoMore) {
    SegmentedLru memory(4, 2, 3);
    EXPECT_FALSE(memory.use(0).unmapped);
    EXPECT_FALSE(memory.use(1).unmapped);
    EXPECT_EQ(memory.use(2).unmapped, 0U);
    EXPECT_EQ(memory.use(0).how, PageUse::soft);  // unmaps 1
    EXPECT_EQ(memory.use(3).unmapped, 2U);        // 1, least recent, goes
    EXPECT_EQ(memory.use(1).how, PageUse::hard);
}

constexpr std::size_t pages = 300;

std::size_t page_size() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }

/// Pages of shared memory; page i is full of bytes i mod 251.
class SharedPages {
  public:
    SharedPages() : file_(memfd_create("test", MFD_CLOEXEC)) {
        if (ftruncate(file_, static_cast<off_t>(pages * page_size())) != 0) return;
        void* const place = mmap(nullptr, pages * page_size(), PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
        base_ = static_cast<std::byte*>(place);
        madvise(base_, pages * page_size(), MADV_NOHUGEPAGE);
        for (std::size_t i = 0; i < pages; ++i)
            std::memset(base_ + i * page_size(), static_cast<int>(i % 251), page_size());
    }
    ~SharedPages() {
        munmap(base_, pages * page_size());
        close(file_);
    }
    SharedPages(const SharedPages&) = delete;
    SharedPages& operator=(const SharedPages&) = delete;

    [[nodiscard]] std::byte* base() const { return base_; }
    [[nodiscard]] bool is_right(std::size_t page, std::size_t offset) const {
        const volatile std::byte* const place = base_ + page * page_size() + offset % page_size();
        return static_cast<std::size_t>(*place) == page % 251;
    }

  private:
    int file_;
    std::byte* base_ = nullptr;
};

/// Refused for a stated reason, and then there is nothing to test.
bool refused(const Expected<std::unique_ptr<FaultPager>>& pager) {
    if (!pager.value) {
        EXPECT_THAT(pager.reason, testing::HasSubstr("userfaultfd"));
        EXPECT_FALSE(pager.remedy.empty());
    }
    return !pager.value;
}

TEST(FaultPager, CountsWhatItsPolicySaysAndKeepsContents) {
    const SharedPages memory;
    const auto pager = FaultPager::make(memory.base(), pages * page_size(), SegmentedLru(pages, 20, 100));
    if (refused(pager)) return;
    SegmentedLru policy(pages, 20, 100);
    scene::Rng rng(3);
    FaultCounts expected;
    for (int i = 0; i < 20000; ++i) {
        const auto page = static_cast<std::uint32_t>(rng.uniform() * rng.uniform() * pages);
        ASSERT_TRUE(memory.is_right(page, static_cast<std::size_t>(i) * 7));
        const PageUse how = policy.use(page).how;
        expected.soft += how == PageUse::soft || how == PageUse::first;
        expected.hard += how == PageUse::hard;
    }
    const FaultCounts counts = (*pager.value)->take_counts();
    EXPECT_EQ(counts.soft, expected.soft);
    EXPECT_EQ(counts.hard, expected.hard);
    EXPECT_GT(counts.hard, 1000U);
    EXPECT_EQ((*pager.value)->take_counts().hard, 0U) << "taken";
}

TEST(FaultPager, WaitsInHardFaultsAlone) {
    const SharedPages memory;
    const auto pager = FaultPager::make(memory.base(), pages * page_size(), SegmentedLru(pages, 2, 10));
    if (refused(pager)) return;
    (*pager.value)->set_wait_ns(1e6);
    const Stopwatch watch;
    for (int round = 0; round < 2; ++round)
        for (std::size_t page = 0; page < 20; ++page) ASSERT_TRUE(memory.is_right(page, 0));
    EXPECT_GE(watch.elapsed_ns(), 20e6);
    for (std::size_t page = 15; page < 18; ++page) ASSERT_TRUE(memory.is_right(page, 0));
    const FaultCounts counts = (*pager.value)->take_counts();
    EXPECT_EQ(counts.hard, 20U);
    EXPECT_EQ(counts.soft, 23U) << "first uses and three pages that are held";
}

TEST(FaultPager, LeavesMemoryAsItWas) {
    const SharedPages memory;
    {
        const auto pager = FaultPager::make(memory.base(), pages * page_size(), SegmentedLru(pages, 1, 1));
        if (refused(pager)) return;
    }
    for (std::size_t page = 0; page < pages; ++page) EXPECT_TRUE(memory.is_right(page, 1));
}

TEST(FaultPager, IsRefusedTwiceAndForOtherMemory) {
    const SharedPages memory;
    {
        const auto first = FaultPager::make(memory.base(), pages * page_size(), SegmentedLru(pages, 1, 2));
        if (refused(first)) return;
        const auto second = FaultPager::make(memory.base(), pages * page_size(), SegmentedLru(pages, 1, 2));
        EXPECT_FALSE(second.value);
        EXPECT_THAT(second.reason, testing::HasSubstr("another pager"));
    }
    void* const own = mmap(nullptr, page_size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const auto pager = FaultPager::make(static_cast<std::byte*>(own), page_size(), SegmentedLru(1, 1, 1));
    EXPECT_FALSE(pager.value);
    EXPECT_THAT(pager.reason, testing::HasSubstr("registering the tables' memory"));
    munmap(own, page_size());
}

}  // namespace
}  // namespace edgewise::measure
