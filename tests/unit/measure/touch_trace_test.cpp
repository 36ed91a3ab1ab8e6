// SPDX-License-Identifier: MIT
//
// Structures of a user's own: places that do not depend on addresses, bytes by member, and what queries that
// touch known lines are found to touch.
#include "edgewise/measure/touch/touch_trace.hpp"

#include <gmock/gmock.h>

#include <array>
#include <vector>

#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/lock/lock_program.hpp"

namespace edgewise::measure {
namespace {

using testing::HasSubstr;

struct Halfling {
    double weight = 0;
    std::int32_t left = -1, right = -1;
    char mark = 'x';
};
enum Part { weight, sons };

const std::vector<Member> members = {{"weight", 8}, {"sons", 8}, {"mark", 1}};

TEST(Structure, HasPlacesThatDoNotDependOnAddresses) {
    alignas(64) std::array<std::byte, 4096> memory{};
    for (const std::size_t shift : {0, 8, 24, 72}) {
        Structure structure;
        structure.add_memory("first", memory.data() + shift, 3, 24, {});
        structure.add_memory("second", memory.data() + 2000 - shift, 2, 10, {}, 16);
        EXPECT_EQ(structure.place_of(memory.data() + shift, 8), 0U);
        EXPECT_EQ(structure.place_of(memory.data() + shift + 48, 24), 48U);
        // Behind 72 bytes, at a multiple of 16.
        EXPECT_EQ(structure.place_of(memory.data() + 2000 - shift, 1), 80U);
        EXPECT_EQ(structure.place_of(memory.data() + 2000 - shift + 13, 7), 93U);
        EXPECT_EQ(structure.place_of(memory.data() + shift + 71, 2), std::nullopt) << "over the end";
        EXPECT_EQ(structure.place_of(memory.data() + shift + 72, 1), std::nullopt) << "behind the end";
        EXPECT_EQ(structure.place_of(memory.data() + 2000 - shift - 1, 1), std::nullopt) << "before";
    }
}

TEST(Structure, BooksBytesByMember) {
    const std::vector<Halfling> some(10), more(5);
    Structure structure;
    structure.add_array("halflings", some, members);
    structure.add_array("halflings", more, members);
    std::vector<std::pair<std::string, std::uint64_t>> found;
    for (const ComponentBytes& part : structure.bytes()) found.emplace_back(part.component, part.bytes);
    EXPECT_THAT(found, testing::ElementsAre(testing::Pair("halflings.weight", 120U),
                                            testing::Pair("halflings.sons", 120U),
                                            testing::Pair("halflings.mark", 15U),
                                            testing::Pair("halflings.padding", 15 * 7U)));
}

TEST(Structure, SaysWhatIsWrongWithIt) {
    const std::vector<Halfling> some(10);
    Structure twice;
    twice.add_array("all", some, members);
    twice.add_memory("last", &some.back(), 1, sizeof(Halfling), members);
    EXPECT_THAT(twice.problem(),
                testing::AllOf(HasSubstr("'all'"), HasSubstr("'last'"), HasSubstr("overlap")));
    Structure large;
    large.add_array("all", some, {{"weight", 25}});
    EXPECT_THAT(large.problem(), testing::AllOf(HasSubstr("25"), HasSubstr("24")));
    Structure odd;
    odd.add_memory("all", some.data(), 10, 24, members, 48);
    EXPECT_THAT(odd.problem(), HasSubstr("power of two"));
}

/// Ten elements of 24 bytes: 0 and 1 lie in the first line, 2 in the first two.
struct Tale {
    std::vector<Halfling> some = std::vector<Halfling>(10);
    TouchTrace trace{structure(), {"weight", "sons"}};

    Structure structure() const {
        Structure all;
        all.add_array("halflings", some, members);
        return all;
    }
    const Expected<LayoutFacts> facts() const {
        return measure_layout(trace, described_machines({"zen5", "pentium3_coppermine"}));
    }
};

TEST(TouchTrace, CountsLinesByTheStartOfQueries) {
    Tale tale;
    const TouchReads reads(tale.trace);
    tale.trace.start_query();
    EXPECT_EQ(reads.load(tale.some[0].left, sons), -1);
    reads.load(tale.some[1].weight, weight);
    reads.load(tale.some[2], weight);  // 48 .. 71: two lines
    tale.trace.start_query(QueryStart::warm);
    reads.load(tale.some[9].weight, weight);  // 216 .. 223: the fourth line
    tale.trace.end_query();
    tale.trace.touch(&tale.some[3], 4, weight);  // no query's
    tale.trace.write(&tale.some[3], 4, weight);
    const Expected<LayoutFacts> facts = tale.facts();
    ASSERT_TRUE(facts.value) << facts.reason;
    EXPECT_EQ(facts.value->lines.cold.queries, 1U);
    EXPECT_EQ(facts.value->lines.cold.lines, 2U);
    EXPECT_EQ(facts.value->lines.cold.reads, 3U);
    EXPECT_EQ(facts.value->lines.warm.lines, 1U);
    EXPECT_EQ(facts.value->lines.all.lines, 3U);
    EXPECT_EQ(facts.value->distinct_lines, 3U);
    EXPECT_EQ(PlainReads().load(tale.some[0].left, sons), -1);
}

/// Two elements that share a set of a cache of one way, over and over.
TEST(TouchTrace, FindsMissesByField) {
    std::vector<std::array<std::byte, 64>> lines(513);
    Structure structure;
    structure.add_array("lines", lines, {});
    TouchTrace trace(structure, {"weight", "sons"});
    for (int query = 0; query < 10; ++query) {
        trace.start_query();
        trace.touch(lines.data(), 8, weight);
        trace.touch(&lines[512], 8, sons);
        trace.touch(&lines[1], 8, sons);
    }
    const CacheMachine machine = parse_cache_machine(
        R"({"what": "one way", "clock_mhz": 1, "line_bytes": 64,
            "levels": [{"name": "L1", "bytes": 32768, "ways": 1, "latency_cycles": 1, "source": "me"}],
            "memory": {"latency_cycles": 2, "source": "me"}})",
        "one_way");
    const Expected<LayoutFacts> facts = measure_layout(trace, {&machine, 1});
    ASSERT_TRUE(facts.value);
    const LevelMisses& level = facts.value->machines[0].steady.cold.caches[0];
    EXPECT_EQ(level.by_field, (std::vector<std::uint64_t>{10, 10}));
    EXPECT_EQ(level.misses.conflict, 20U);
    EXPECT_EQ(facts.value->machines[0].emptied.cold, 30U);
    // Nine tenths of what a query comes back to: three lines.
    EXPECT_EQ(facts.value->knee_bytes.cold, 3 * 64U);
    EXPECT_THAT(to_text(*facts.value), HasSubstr("misses_per_query.one_way.L1.cold of sons: 1\n"));
}

TEST(TouchTrace, RefusesWhatNoArrayHolds) {
    Tale stray, nameless, silent;
    const double elsewhere = 0;
    stray.trace.start_query();
    stray.trace.touch(&stray.some[0], 8, weight);
    stray.trace.touch(&elsewhere, 8, sons);
    EXPECT_FALSE(stray.facts().value);
    EXPECT_THAT(stray.facts().reason, testing::AllOf(HasSubstr("'sons'"), HasSubstr("touch 2")));
    nameless.trace.touch(&nameless.some[0], 8, 2);
    EXPECT_THAT(nameless.facts().reason, HasSubstr("field 2"));
    EXPECT_THAT(silent.facts().reason, HasSubstr("no queries"));
}

}  // namespace
}  // namespace edgewise::measure
