// SPDX-License-Identifier: MIT
//
// The policy against plain lists that are searched; with one mapped page against exact reuse distances, with
// all mapped against a queue.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <deque>
#include <set>

#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/cache/segmented_lru.hpp"
#include "edgewise/measure/process/fault_pager.hpp"
#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::measure {
namespace {

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
    EXPECT_EQ(counts.waited_ns, 20e6);
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
