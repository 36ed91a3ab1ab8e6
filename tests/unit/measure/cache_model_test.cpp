// SPDX-License-Identifier: MIT
//
// Compares the cache model with results computed by hand and, on random streams, with one plain list per set.
#include "edgewise/measure/cache/cache_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <random>
#include <vector>

#include "edgewise/measure/counters/calibration.hpp"

namespace edgewise::measure {
namespace {

using Kind = AccessKind;

LevelGeometry level(std::uint32_t sets, std::uint32_t ways, Inclusion inclusion = Inclusion::non_inclusive,
                    Replacement replacement = Replacement::lru) {
    return {"", sets, ways, inclusion, replacement};
}

CacheModel model_of(std::vector<LevelGeometry> levels, std::uint32_t line = 64,
                    LineCrossing crossing = LineCrossing::split) {
    return CacheModel({line, std::move(levels), crossing});
}

/// Reads line numbers; the misses of the first level.
std::uint64_t misses_of(CacheModel& model, const std::vector<std::uint64_t>& lines, int times = 1) {
    const std::uint64_t before = model.counts(0).misses;
    for (int i = 0; i < times; ++i) {
        for (const std::uint64_t line : lines)
            model.access(line * model.geometry().line_bytes, 1, Kind::read);
    }
    return model.counts(0).misses - before;
}

TEST(CacheModel, ASequenceMissesOnceALine) {
    for (const std::uint32_t line : {32U, 64U, 128U}) {
        CacheModel model = model_of({level(8, 4)}, line);
        for (std::uint64_t at = 0; at < 4096; at += 8) model.access(at, 8, Kind::read);
        EXPECT_EQ(model.counts(0).accesses, 512U);
        EXPECT_EQ(model.counts(0).misses, 4096 / line);
    }
}

TEST(CacheModel, AReferenceThatCrossesALineIsTwoAccessesOrOne) {
    CacheModel split = model_of({level(8, 2)});
    EXPECT_EQ(split.access(60, 8, Kind::read), 1U);
    EXPECT_EQ(split.counts(0).accesses, 2U);
    EXPECT_EQ(split.counts(0).misses, 2U);
    CacheModel merge = model_of({level(8, 2)}, 64, LineCrossing::merge);
    merge.access(60, 8, Kind::read);
    EXPECT_EQ(merge.counts(0).accesses, 1U);
    EXPECT_EQ(merge.counts(0).misses, 1U);
    merge.access(64, 4, Kind::read);
    EXPECT_EQ(merge.counts(0).misses, 1U);  // both lines came
    merge.access(124, 8, Kind::read);
    EXPECT_EQ(merge.counts(0).misses, 2U);                         // one is there, one is not
    EXPECT_EQ(split.access(UINT64_MAX - 67, 68, Kind::read), 1U);  // ends where addresses do
    EXPECT_EQ(split.counts(0).misses, 4U);
}

/// Tree-PLRU over four ways: after 0 1 2 3 the tree points at 0; a use of 0 turns it to 2.
TEST(CacheModel, ATreePointsAwayFromWhatWasUsed) {
    CacheModel model = model_of({level(1, 4, Inclusion::non_inclusive, Replacement::tree_plru)});
    EXPECT_EQ(misses_of(model, {0, 1, 2, 3}), 4U);
    EXPECT_EQ(misses_of(model, {0}), 0U);
    EXPECT_EQ(misses_of(model, {4}), 1U);  // 2 goes; LRU would have thrown 1 out
    EXPECT_EQ(misses_of(model, {0, 1, 3}), 0U);
    EXPECT_EQ(misses_of(model, {2}), 1U);
}

/// Three ways: a left subtree of two and a leaf.
TEST(CacheModel, ATreeMayBeUneven) {
    CacheModel model = model_of({level(1, 3, Inclusion::non_inclusive, Replacement::tree_plru)});
    EXPECT_EQ(misses_of(model, {0, 1, 2}), 3U);
    EXPECT_EQ(misses_of(model, {3}), 1U);  // root points left (2 was last), there at 0
    EXPECT_EQ(misses_of(model, {1, 2}), 0U);
    EXPECT_EQ(misses_of(model, {0}), 1U);
}

TEST(CacheModel, ARandomVictimIsTheSameEveryTime) {
    std::vector<std::uint64_t> lines(9);
    for (std::uint64_t i = 0; i < lines.size(); ++i) lines[i] = i;
    std::uint64_t misses[2];
    for (std::uint64_t& count : misses) {
        CacheModel model = model_of({level(1, 8, Inclusion::non_inclusive, Replacement::random)});
        count = misses_of(model, lines, 1000);
    }
    EXPECT_EQ(misses[0], misses[1]);
    EXPECT_LT(misses[0], 9000U * 3 / 4);  // where LRU misses all of them
    EXPECT_GT(misses[0], 9000U / 9);
}

TEST(CacheModel, AVictimCacheSwapsWithTheLevelAbove) {
    CacheModel model = model_of({level(1, 1), level(1, 1, Inclusion::exclusive)});
    const auto depth = [&](std::uint64_t line) { return model.access(line * 64, 1, Kind::read); };
    EXPECT_EQ(depth(0), 2U);
    EXPECT_EQ(depth(1), 2U);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(depth(static_cast<std::uint64_t>(i) % 2), 1U);
    EXPECT_EQ(model.counts(1).misses, 2U);
    // Without exclusion the second level only repeats the first, and both thrash.
    CacheModel repeats = model_of({level(1, 1), level(1, 1)});
    for (std::uint64_t i = 0; i < 10; ++i) EXPECT_EQ(repeats.access(i % 2 * 64, 1, Kind::read), 2U);
}

/// A line that the first level hits all the time looks unused to an inclusive second level, which takes it
/// away.
TEST(CacheModel, AnInclusiveLevelTakesLinesFromThoseAbove) {
    const auto deep = [](Inclusion inclusion) {
        CacheModel model = model_of({level(1, 3), level(1, 2, inclusion)});
        for (const std::uint64_t line : {0, 1, 0, 0, 2}) model.access(line * 64, 1, Kind::read);
        return model.access(0, 1, Kind::read);
    };
    EXPECT_EQ(deep(Inclusion::non_inclusive), 0U);
    EXPECT_EQ(deep(Inclusion::inclusive), 2U);
}

TEST(CacheModel, DirtyLinesAreWrittenBackOnce) {
    CacheModel model = model_of({level(1, 1), level(1, 4)});
    model.access(0, 8, Kind::write);
    model.access(0, 8, Kind::write);
    model.access(64, 8, Kind::read);  // 0 goes to the second level
    EXPECT_EQ(model.counts(0).write_backs, 1U);
    EXPECT_EQ(model.counts(1).write_backs, 0U);
    model.access(0, 8, Kind::read);  // 1 was clean
    EXPECT_EQ(model.counts(0).write_backs, 1U);
    for (std::uint64_t line = 2; line < 6; ++line) model.access(line * 64, 8, Kind::read);
    EXPECT_EQ(model.counts(1).write_backs, 1U);
}

TEST(CacheModel, KnowsWhatOfALineWasNeverUsed) {
    for (const std::uint32_t line : {32U, 64U, 128U}) {
        CacheModel model = model_of({level(1, 1)}, line);
        model.access(8, 8, Kind::read);
        model.access(10, 4, Kind::read);
        model.access(24, 2, Kind::read);
        EXPECT_EQ(model.fetched().bytes, line);
        EXPECT_EQ(model.fetched().unused, line - 10);
        model.access(line, 4, Kind::read);  // the first goes
        EXPECT_EQ(model.fetched().bytes, 2 * line);
        EXPECT_EQ(model.fetched().unused, 2 * line - 14);
    }
}

/// Lists of one level: the most recent first.
class PlainCache {
  public:
    PlainCache(std::uint32_t sets, std::uint32_t ways) : ways_(ways), sets_(sets) {}
    bool hits(std::uint64_t line) {
        std::deque<std::uint64_t>& set = sets_[line % sets_.size()];
        const auto found = std::find(set.begin(), set.end(), line);
        const bool hit = found != set.end();
        if (hit) set.erase(found);
        set.push_front(line);
        if (set.size() > ways_) set.pop_back();
        return hit;
    }

  private:
    std::size_t ways_;
    std::vector<std::deque<std::uint64_t>> sets_;
};

TEST(CacheModel, IsAListASetOnRandomStreams) {
    const std::pair<std::uint32_t, std::uint32_t> shapes[] = {{64, 8}, {64, 12}, {48, 11},
                                                              {7, 3},  {1, 40},  {12, 1}};
    for (const auto& [sets, ways] : shapes) {
        CacheModel model = model_of({level(sets, ways), level(4 * sets, 16)});
        PlainCache first(sets, ways), second(4 * sets, 16);
        std::mt19937_64 bits(sets);
        std::uint64_t seen[3] = {};
        for (int i = 0; i < 200000; ++i) {
            const std::uint64_t line = bits() % (bits() % 4 == 0 ? 100 * sets : 3 * sets * ways);
            const std::size_t expected = first.hits(line) ? 0 : second.hits(line) ? 1 : 2;
            ++seen[expected];
            ASSERT_EQ(model.access(line * 64 + 8, 8, Kind::read), expected)
                << sets << "x" << ways << " " << i;
        }
        for (const std::uint64_t count : seen) EXPECT_GT(count, 1000U);
    }
}

// Random pointer chases: the model gets exactly the loads that run, and its miss rate is the expected one.

TEST(RandomChases, GoWhereTheReplayGoes) {
    RandomChase run(1 << 16), replayed(1 << 16);
    EXPECT_EQ(run.lines(), 1024U);
    std::vector<std::uint64_t> lines;
    run.run(5000);
    replayed.replay(5000, [](std::uint64_t) {});
    std::vector<std::uint64_t> after_run, after_replay;
    run.replay(5000, [&](std::uint64_t line) { after_run.push_back(line); });
    replayed.replay(5000, [&](std::uint64_t line) { after_replay.push_back(line); });
    EXPECT_EQ(after_run, after_replay);
    std::vector<int> met(1024, 0);
    for (const std::uint64_t line : after_run) ++met.at(line);
    for (const int times : met) EXPECT_LT(times, 30) << "nearly five each";
}

/// With N lines in a cache of C lines, a fraction (N - C) / N of random loads misses.
TEST(Calibration, ModelsWhatArithmeticSays) {
    CacheMachine machine;
    machine.name = "made up";
    machine.caches = {64, {{"L1D", 64, 8}, {"L2", 512, 16}}};
    machine.origins.resize(2);
    CalibrationOptions options;
    options.loads = 200'000;
    const auto rows = calibrate_model(machine, Cpu{}, options);
    ASSERT_EQ(rows.size(), 8U);
    for (const CalibrationRow& row : rows) {
        const double expected = row.times > 1 ? 1 - 1 / row.times : 0;
        EXPECT_NEAR(row.modelled.value(), expected, 0.01);
        EXPECT_GT(row.ns.value(), 0);
        EXPECT_NE(row.counted.has_value(), !row.reason.empty()) << "counted, or said why not";
    }
}

}  // namespace
}  // namespace edgewise::measure
