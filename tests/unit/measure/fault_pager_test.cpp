// SPDX-License-Identifier: MIT
//
// The pager on real memory: what it counts is what its policy says of the same uses, contents survive, and
// what it cannot do it says. Where the kernel refuses userfaultfd the reason must say so.
#include "edgewise/measure/process/fault_pager.hpp"

#include <gmock/gmock.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstring>

#include "edgewise/measure/stopwatch.hpp"
#include "edgewise/scene/rng.hpp"

namespace edgewise::measure {
namespace {

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
