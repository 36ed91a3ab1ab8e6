// SPDX-License-Identifier: MIT
//
// Shards: how one is named, by hand or by a scheduler, and that all of them together have every unit once,
// evenly.
#include "edgewise/sweep/shard.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <numeric>
#include <set>

namespace edgewise::sweep {
namespace {

using ::testing::HasSubstr;

using Variables = std::map<std::string, std::string>;

Result<Shard> parsed(const std::string& text, const Variables& variables = {}) {
    return parse_shard(text, [&](const char* name) {
        const auto found = variables.find(name);
        return found == variables.end() ? nullptr : found->second.c_str();
    });
}

TEST(Shard, IsNamedByHand) {
    EXPECT_EQ(parsed("0/1")->text(), "0/1");
    EXPECT_TRUE(parsed("0/1")->is_whole());
    EXPECT_EQ(parsed("7/8")->text(), "7/8");
    for (const char* text : {"", "/", "3", "8/8", "-1/8", "1/0", "1/-8", "+1/8", " 1/8", "1/8 ", "1/8/2",
                             "0x1/8", "1/100001", "a/b", "1e0/8"}) {
        const auto shard = parsed(text);
        ASSERT_FALSE(shard) << text;
        EXPECT_THAT(shard.error, HasSubstr("--shard"));
    }
    EXPECT_THAT(parsed("8/8").error, HasSubstr("count from 0 to 7"));
}

TEST(Shard, IsWhatTheSchedulerSays) {
    EXPECT_EQ(parsed("auto", {{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_COUNT", "8"}})->text(), "3/8");
    EXPECT_EQ(parsed("auto/4", {{"SLURM_ARRAY_TASK_ID", "3"}})->text(), "3/4");
    EXPECT_EQ(parsed("auto/4", {{"JOB_COMPLETION_INDEX", "0"}})->text(), "0/4");
    EXPECT_EQ(parsed("auto", {{"OMPI_COMM_WORLD_RANK", "1"}, {"OMPI_COMM_WORLD_SIZE", "2"}})->text(), "1/2");
    EXPECT_EQ(parsed("auto/9", {{"PBS_ARRAY_INDEX", "8"}})->text(), "8/9");
    EXPECT_EQ(parsed("auto", {{"SGE_TASK_ID", "1"}, {"SGE_TASK_LAST", "5"}})->text(), "0/5");
    EXPECT_EQ(parsed("auto/5", {{"SGE_TASK_ID", "undefined"}, {"PARALLEL_SEQ", "5"}})->text(), "4/5");
    EXPECT_THAT(parsed("auto").error, HasSubstr("SLURM_ARRAY_TASK_ID"));
    EXPECT_THAT(parsed("auto", {{"PARALLEL_SEQ", "1"}}).error, HasSubstr("auto/n"));
    EXPECT_THAT(parsed("auto/3", {{"SLURM_ARRAY_TASK_ID", "3"}}).error, HasSubstr("0 to 2"));
}

std::vector<ShardUnit> some_units(std::size_t count) {
    std::vector<ShardUnit> units;
    for (std::size_t i = 0; i < count; ++i)
        units.push_back({"unit " + std::to_string(i), static_cast<double>(1 + i * i % 97)});
    return units;
}

TEST(Shard, HasOneRangeOfPiecesInARow) {
    for (const std::size_t pieces : {0ULL, 1ULL, 7ULL, 244'141ULL, ~0ULL}) {
        for (const std::size_t count : {1ULL, 3ULL, 8ULL, 1000ULL}) {
            std::size_t next = 0;
            for (std::size_t i = 0; i < count; ++i) {
                const Shard shard{i, count};
                EXPECT_EQ(shard.first_of(pieces), next);
                next = shard.last_of(pieces);
            }
            EXPECT_EQ(next, pieces);
        }
    }
}

TEST(Shards, HaveEveryUnitOnceEvenly) {
    for (const std::size_t count : {1U, 2U, 3U, 8U, 50U}) {
        const auto units = some_units(40);
        const double all = std::accumulate(units.begin(), units.end(), 0.0,
                                           [](double sum, const ShardUnit& unit) { return sum + unit.cost; });
        std::set<std::size_t> dealt;
        double most = 0, dearest = 0;
        for (const ShardUnit& unit : units) dearest = std::max(dearest, unit.cost);
        for (std::size_t index = 0; index < count; ++index) {
            double load = 0;
            for (const std::size_t unit : dealt_to({index, count}, units)) {
                EXPECT_TRUE(dealt.insert(unit).second) << "dealt twice";
                load += units[unit].cost;
            }
            most = std::max(most, load);
        }
        EXPECT_EQ(dealt.size(), units.size());
        const double mean = all / static_cast<double>(count);
        std::printf("%zu shards: the fullest has %.2f of the mean\n", count, most / mean);
        EXPECT_LE(most, std::max(4.0 / 3 * std::max(mean, dearest), dearest)) << "Graham's bound";
    }
}

/// Whoever lists them in whichever order deals the same.
TEST(Shards, DependOnNamesAndCostsAlone) {
    auto units = some_units(30);
    for (ShardUnit& unit : units) unit.cost = 1;
    const auto names = [&](const std::vector<ShardUnit>& of) {
        std::set<std::string> mine;
        for (const std::size_t unit : dealt_to({1, 4}, of)) mine.insert(of[unit].name);
        return mine;
    };
    const auto before = names(units);
    std::reverse(units.begin(), units.end());
    EXPECT_EQ(names(units), before);
}

TEST(Shards, AreWeighedBySecondsWhereTheseAreKnown) {
    std::vector<ShardUnit> units = {{"a", 10}, {"b", 20}, {"c", 40}};
    weigh(units, {{"a", 1}, {"b", 5}, {"z", 99}});
    EXPECT_EQ(units[0].cost, 1);
    EXPECT_EQ(units[1].cost, 5);
    EXPECT_DOUBLE_EQ(units[2].cost, 8) << "as the others took for what was predicted";
    weigh(units, {});
    EXPECT_DOUBLE_EQ(units[2].cost, 8);
}

}  // namespace
}  // namespace edgewise::sweep
