// SPDX-License-Identifier: MIT
//
// Prefetchers against a second implementation that keeps a plain list of lines for the cache and for the
// pages that are followed, and on sequences whose misses were counted by hand.
#include "edgewise/measure/cache/prefetcher.hpp"

#include <gtest/gtest.h>

#include <list>
#include <numeric>
#include <random>

#include "edgewise/measure/cache/scene_caches.hpp"

namespace edgewise::measure {
namespace {

using Lines = std::vector<std::uint64_t>;

/// One set of `ways` lines of 64 bytes.
std::uint64_t misses(const std::string& prefetcher, std::uint32_t ways, const Lines& lines) {
    CacheMachine machine;
    machine.name = "small" + prefetcher;
    machine.caches = {64, {{"L1", 1, ways}}};
    machine.origins = {{3, "made up", {}}};
    SceneCaches caches({&machine, 1}, 1, 1);
    for (const std::uint64_t line : lines)
        caches.on_access({line * 64, 8, AccessKind::read, 0, 0, TraceSide::table_a});
    caches.on_query_end(true);
    return caches.steady()[0].all.caches[0].misses.all();
}

/// By lists that are searched from one end to the other.
struct NaiveCache {
    std::size_t ways;
    std::list<std::uint64_t> lines = {};  // used last is first
    std::list<std::pair<std::uint64_t, Lines>> pages = {};
    std::uint64_t missed = 0;

    bool touch(std::uint64_t line) {
        const auto found = std::find(lines.begin(), lines.end(), line);
        const bool hit = found != lines.end();
        if (hit) lines.erase(found);
        lines.push_front(line);
        if (lines.size() > ways) lines.pop_back();
        return hit;
    }
    void next_line(std::uint64_t line) {
        if (touch(line)) return;
        ++missed;
        if ((line + 1) % 64 != 0) touch(line + 1);
    }
    void stream(std::uint64_t line) {
        if (touch(line)) return;
        ++missed;
        Lines history;
        for (auto page = pages.begin(); page != pages.end(); ++page) {
            if (page->first != line / 64) continue;
            history = page->second;
            pages.erase(page);
            break;
        }
        history.push_back(line);
        pages.emplace_front(line / 64, history);
        if (pages.size() > 32) pages.pop_back();
        if (history.size() < 3) return;
        const std::uint64_t a = history[history.size() - 3], b = history[history.size() - 2];
        for (std::uint64_t ahead = 1; ahead <= 2; ++ahead) {
            if (a < b && b < line && (line + ahead) / 64 == line / 64) touch(line + ahead);
            if (a > b && b > line && line % 64 >= ahead) touch(line - ahead);
        }
    }
};

/// Of 0 to 15 the next line misses every other one; a stream misses 0, 1 and 2, which brings 3 and 4, then 5,
/// 8, 11 and 14.
TEST(Prefetcher, MissesOfASequenceAreFew) {
    Lines upwards(16);
    std::iota(upwards.begin(), upwards.end(), std::uint64_t{0});
    EXPECT_EQ(misses("", 64, upwards), 16U);
    EXPECT_EQ(misses("/next_line", 64, upwards), 8U);
    EXPECT_EQ(misses("/stream", 64, upwards), 7U);
}

TEST(Prefetcher, IsASecondImplementationOnRandomStreams) {
    std::mt19937 random(7);
    for (int round = 0; round < 30; ++round) {
        Lines lines;
        while (lines.size() < 3000) {
            const std::uint64_t start = random() % 6000, step = random() % 3, length = 1 + random() % 12;
            for (std::uint64_t i = 0; i < length; ++i) lines.push_back(6000 + start + i * step - i);
        }
        const auto ways = static_cast<std::uint32_t>(4 + random() % 60);
        NaiveCache next{ways}, stream{ways};
        for (const std::uint64_t line : lines) next.next_line(line), stream.stream(line);
        EXPECT_EQ(misses("/next_line", ways, lines), next.missed);
        EXPECT_EQ(misses("/stream", ways, lines), stream.missed);
    }
}

}  // namespace
}  // namespace edgewise::measure
