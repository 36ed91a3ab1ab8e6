// SPDX-License-Identifier: MIT
//
// The policy against plain lists that are searched; with one mapped page against exact reuse distances, with
// all mapped against a queue.
#include "edgewise/measure/cache/segmented_lru.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <set>

#include "edgewise/measure/cache/reuse_distance.hpp"
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

/// The same by two queues, newest first.
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

}  // namespace
}  // namespace edgewise::measure
