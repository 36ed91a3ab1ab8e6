// SPDX-License-Identifier: MIT
#include "edgewise/measure/cache/cache_machine.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "../complaint.hpp"

namespace edgewise::measure {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

TEST(CacheMachines, AreThoseOfTheManifestWithASourceForEveryLevel) {
    std::set<std::string> names;
    for (const CacheMachine& machine : cache_machines()) {
        SCOPED_TRACE(machine.name);
        names.insert(machine.name);
        EXPECT_FALSE(machine.what.empty());
        EXPECT_EQ(machine.caches.levels.size(), machine.origins.size());
        EXPECT_GE(machine.caches.levels.size(), 2U);
        EXPECT_EQ(machine.tlbs.levels.size(), machine.tlb_origins.size());
        EXPECT_GE(machine.tlbs.levels.size(), 1U);
        double latency = 0;
        std::uint64_t bytes = 0;
        for (std::size_t i = 0; i < machine.origins.size(); ++i) {
            const LevelGeometry& level = machine.caches.levels[i];
            EXPECT_GT(machine.origins[i].latency_cycles, latency) << level.name;
            latency = machine.origins[i].latency_cycles;
            const std::uint64_t size = std::uint64_t{level.sets} * level.ways * machine.caches.line_bytes;
            const bool last_is_small = machine.name == "apple_m1";
            EXPECT_TRUE(size > bytes || last_is_small) << level.name;
            bytes = size;
        }
        EXPECT_GT(machine.memory.latency_cycles, latency);
        const CacheModel caches(machine.caches), tlbs(machine.tlbs);  // every geometry can be modelled
    }
    EXPECT_EQ(names.size(), 16U);
    for (const char* name :
         {"pentium3_coppermine", "athlon_thunderbird", "skylake_sp", "zen5", "raspberry_pi4"})
        EXPECT_TRUE(names.count(name)) << name;
}

/// Expected values are from the sources: numbers of sets, one not a power of two, and an exclusive level.
TEST(CacheMachines, HaveTheGeometryOfTheirSources) {
    for (const CacheMachine& machine : cache_machines()) {
        const auto& levels = machine.caches.levels;
        if (machine.name == "pentium3_coppermine") {
            EXPECT_EQ(machine.caches.line_bytes, 32U);
            EXPECT_EQ(levels[0].sets, 128U);
            EXPECT_EQ(levels[1].sets, 1024U);
            EXPECT_TRUE(machine.latencies_proved());
        } else if (machine.name == "skylake_sp") {
            EXPECT_EQ(levels[2].sets, 36864U);
            EXPECT_EQ(levels[2].ways, 11U);
        } else if (machine.name == "athlon_thunderbird") {
            EXPECT_EQ(levels[1].inclusion, Inclusion::exclusive);
        } else if (machine.name == "zen5") {
            EXPECT_FALSE(machine.latencies_proved());
            EXPECT_FALSE(machine.origins[1].proves("latency_cycles"));
            EXPECT_TRUE(machine.origins[1].proves("bytes"));
        }
    }
}

std::string complaint(const std::string& text) {
    return complaint_of([&] { return parse_cache_machine(text, "mine.json"); });
}

json right_machine() {
    return json::parse(R"({"what": "a test", "clock_mhz": 1000, "line_bytes": 64,
        "levels": [{"name": "L1", "bytes": 8192, "ways": 2, "latency_cycles": 3, "source": "made up"},
                   {"name": "L2", "bytes": 65536, "ways": 4, "latency_cycles": 10, "source": "made up"}],
        "memory": {"latency_cycles": 100, "source": "made up"}})");
}

TEST(CacheMachine, MemoryTimeIsWhatEachAnswerWaitsFor) {
    const CacheMachine machine = parse_cache_machine(right_machine().dump(), "test");
    EXPECT_TRUE(machine.tlbs.levels.empty());
    const LevelCounts counts[] = {{1000, 30, 0}, {30, 4, 0}};
    EXPECT_DOUBLE_EQ(machine.memory_ns(counts), 26 * 10 + 4 * 100);
}

/// What a file may have wrong, and the field and the wish that the error names.
struct Wrong {
    const char* at;
    json value;
    const char *field, *wanted;
};
const Wrong wrong_files[] = {
    {"/clock_mhz", "fast", "clock_mhz", "a number from 1 to"},
    {"/line_bytes", 48, "line_bytes", "a power of two"},
    {"/line_bytes", 8, "line_bytes", "a number from 16 to 1024"},
    {"/levels", json::array(), "levels", "a list, not empty"},
    {"/levels/1", 7, "levels[1]", "an object"},
    {"/levels/1/ways", 0, "levels[1].ways", "a number from 1 to"},
    {"/levels/1/ways", 2.5, "levels[1].ways", "a whole number"},
    {"/levels/1/ways", 3, "levels[1].bytes", "whole sets"},
    {"/levels/1/bytes", 100, "levels[1].bytes", "whole lines"},
    {"/levels/1/name", "", "levels[1].name", "a text, not empty"},
    {"/levels/1/source", 5, "levels[1].source", "a text, not empty"},
    {"/levels/1/inclusion", "both", "levels[1].inclusion", "non_inclusive, inclusive, exclusive"},
    {"/levels/1/replacement", "fifo", "levels[1].replacement", "lru, tree_plru, random"},
    {"/levels/0/inclusion", "exclusive", "levels[0].inclusion", "nothing is above"},
    {"/levels/1/unverified", json::array({"size"}), "levels[1].unverified", "this level's fields"},
    {"/memory", nullptr, "memory", "an object"},
    {"/memory/latency_cycles", -1, "memory.latency_cycles", "a number from 0"},
    {"/tlb", json::object({{"page_bytes", 4096}}), "tlb.levels", "a list, not empty"},
    {"/tlb",
     json::parse(
         R"({"page_bytes":4096,"levels":[{"name":"TLB","entries":64,"ways":4,"inclusion":"exclusive"}]})"),
     "tlb.levels[0].inclusion", "nothing is above"},
    {"/levels/1/ways", 0, "levels[1].ways", "full associativity: that is 1024 here"},
    {"/levels/1/bytes", "64X", "levels[1].bytes", "as 49152 or \"48K\""},
    {"/levels/1/bytes", "384 KiB (8 instances)", "levels[1].bytes", "as 49152 or \"48K\""},
    {"/levels/1/name", "L1", "levels[1].name", "another level is called 'L1'"},
    {"/levels/0/line_bytes", 128, "levels[0].line_bytes", "several sizes are not modelled"},
};

/// A wrong file gives one line: the file, the field, what is wanted.
TEST(CacheMachine, SaysWhatIsWrongWithAFile) {
    for (const Wrong& wrong : wrong_files) {
        json machine = right_machine();
        machine[json::json_pointer(wrong.at)] = wrong.value;
        EXPECT_THAT(
            complaint(machine.dump()),
            AllOf(HasSubstr(std::string("mine.json: ") + wrong.field + ": wants "), HasSubstr(wrong.wanted)))
            << wrong.at;
    }
    EXPECT_NE(complaint("{"), "");
    EXPECT_NE(complaint("[]"), "");
}

/// A misspelt member is refused in every object; the message suggests the nearest known name.
TEST(CacheMachine, HasNoMemberThatNobodyKnows) {
    json full = right_machine();
    full["levels"][1].update({{"inclusion", "inclusive"}, {"replacement", "lru"}, {"unverified", {"ways"}}});
    full["tlb"] = {{"page_bytes", 4096}, {"levels", {{{"name", "dTLB"}, {"entries", 64}, {"ways", 4}}}}};
    const json flat = full.flatten();
    int misspelt = 0;
    for (const auto& [pointer, value] : flat.items()) {
        const std::size_t slash = pointer.rfind('/');
        const std::string name = pointer.substr(slash + 1);
        if (!std::isalpha(static_cast<unsigned char>(name[0]))) continue;
        json wrong = full;
        json& object = wrong[json::json_pointer(pointer.substr(0, slash))];
        object[name + name.back()] = value;
        ++misspelt;
        EXPECT_THAT(complaint(wrong.dump()),
                    AllOf(HasSubstr("'" + name + name.back() + "' is not a member of"),
                          HasSubstr("did you mean '" + name + "'?")))
            << pointer;
    }
    EXPECT_GE(misspelt, 17);
}

TEST(CacheMachine, TakesSizesAsTheyAreWritten) {
    for (const char* size : {"64K", "64 KiB", "64k", "65536"}) {
        json machine = right_machine();
        machine["levels"][1]["bytes"] = size;
        EXPECT_EQ(parse_cache_machine(machine.dump(), "my.json").caches.bytes_of(1), 65536U) << size;
    }
}

}  // namespace
}  // namespace edgewise::measure
