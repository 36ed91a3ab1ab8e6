// SPDX-License-Identifier: MIT
//
// Locks: what a file of one says again when it is read, every kind of difference by name, and what is said of
// files that are none.
#include "edgewise/measure/lock/layout_lock.hpp"

#include <gmock/gmock.h>

namespace edgewise::measure {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const LayoutLock known = {{{"points", "1000"}, {"tree", "k-d"}},
                          {{"bytes", 24000}, {"lines_per_query", 14.1}, {"knee_bytes", 0}}};

std::vector<std::string> texts(const std::vector<LockDifference>& found) {
    std::vector<std::string> lines;
    for (const LockDifference& difference : found) lines.push_back(to_text(difference));
    return lines;
}

std::string complaint(const std::string& json) {
    try {
        static_cast<void>(parse_lock(json, "my.lock.json"));
    } catch (const std::runtime_error& problem) {
        return problem.what();
    }
    return {};
}

TEST(LayoutLock, IsTheSameWhenItIsReadAgain) {
    LayoutLock odd = known;
    odd.figures.emplace_back("third", 1.0 / 3);
    odd.figures.emplace_back("large", 1e15 + 0.125);
    const LayoutLock again = parse_lock(to_json(odd), "my.lock.json");
    EXPECT_EQ(again.of, odd.of);
    EXPECT_EQ(again.figures, odd.figures);
    EXPECT_TRUE(differences(odd, again).empty());
    EXPECT_THAT(to_json(known), HasSubstr("\"bytes\": 24000,"));
}

TEST(LayoutLock, NamesEveryDifference) {
    const LayoutLock now = {{{"points", "1001"}, {"tree", "k-d"}},
                            {{"bytes", 24000}, {"lines_per_query", 14.100000000000001}, {"misses", 2}}};
    EXPECT_THAT(
        texts(differences(known, now)),
        ElementsAre("of.points: was 1000, is 1001", "lines_per_query: was 14.1, is 14.100000000000001",
                    "knee_bytes: was 0, is nothing", "misses: was nothing, is 2"));
    EXPECT_TRUE(differences(now, now).empty());
}

TEST(LayoutLock, SaysWhatAFileWants) {
    EXPECT_THAT(complaint("{"), testing::AllOf(HasSubstr("my.lock.json"), HasSubstr("not JSON")));
    EXPECT_THAT(complaint("[]"), HasSubstr("an object"));
    EXPECT_THAT(complaint(R"({"edgewise_lock": 2})"), HasSubstr("edgewise_lock: wants 1"));
    EXPECT_THAT(complaint(R"({"edgewise_lock": 1})"), HasSubstr("of: wants an object"));
    EXPECT_THAT(complaint(R"({"edgewise_lock": 1, "of": {"a": 1}, "figures": {}})"),
                HasSubstr("of.a: wants a text"));
    EXPECT_THAT(complaint(R"({"edgewise_lock": 1, "of": {}, "figures": {"b": "1"}})"),
                HasSubstr("figures.b: wants a number"));
    EXPECT_THROW(static_cast<void>(read_lock("/nowhere/at/all.json")), std::runtime_error);
    EXPECT_EQ(known.condition("tree", "f"), "k-d");
    EXPECT_THROW(static_cast<void>(known.condition("leaf", "f")), std::runtime_error);
}

/// Populations that are not there have no figures: an absence is a difference, not a 0.
TEST(LayoutLock, HasFiguresOfPopulationsThatAreThere) {
    LayoutFacts facts;
    facts.bytes = {{"nodes.a", 10}, {"nodes.b", 5}};
    facts.lines.all = facts.lines.warm = {4, 9, 30, 6};
    facts.knee_bytes.all = facts.knee_bytes.warm = 128;
    LevelMisses level{"L1", 9, 0, {1, 2, 3}, {6}, {6}};
    MachineMisses misses;
    misses.caches = {level};
    facts.machines = {{"small", {misses, {}, misses}, {10, 0, 10}}};
    using Figure = std::pair<std::string, double>;
    EXPECT_THAT(
        lock_of(facts).figures,
        ElementsAre(Figure{"bytes.nodes.a", 10}, Figure{"bytes.nodes.b", 5}, Figure{"bytes", 15},
                    Figure{"distinct_lines", 0}, Figure{"queries", 4}, Figure{"lines_per_query", 1.5},
                    Figure{"knee_bytes", 128}, Figure{"queries.warm", 4}, Figure{"lines_per_query.warm", 1.5},
                    Figure{"knee_bytes.warm", 128}, Figure{"misses_per_query.small.L1", 1.5},
                    Figure{"emptied_misses_per_query.small.L1", 2.5},
                    Figure{"misses_per_query.small.L1.warm", 1.5},
                    Figure{"emptied_misses_per_query.small.L1.warm", 2.5}));
}

}  // namespace
}  // namespace edgewise::measure
