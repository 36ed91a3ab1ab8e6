// SPDX-License-Identifier: MIT
//
// Traces in files: every kind of line of either form, lines that are none, and a trace that is written, read
// again and modelled as it was.
#include "edgewise/measure/traces/trace_file.hpp"

#include <gmock/gmock.h>

#include <random>
#include <sstream>

#include "../complaint.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/cache/scene_caches.hpp"

namespace edgewise::measure {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// "r 1f40 8": kind, address and size of each access in hexadecimal.
std::vector<std::string> accesses(const std::string& text, const TraceReading& reading,
                                  TraceCounts* counts = nullptr) {
    std::istringstream stream(text);
    std::vector<std::string> found;
    const TraceCounts counted = read_trace(stream, "t", reading, [&](const FileAccess& access) {
        std::ostringstream line;
        line << (access.kind == AccessKind::read ? "r " : "w ") << std::hex << access.address << ' '
             << access.bytes;
        found.push_back(line.str());
    });
    if (counts) *counts = counted;
    return found;
}

std::string complaint(const std::string& text, TraceForm form) {
    return complaint_of([&] { return accesses(text, {form, false}); });
}

TEST(TraceFile, ReadsBothFormsOfDin) {
    const std::string text =
        "r 1f40 10\nw 0x1f4f 1 a comment\ni 400 4\nm 1f50 8\n\n# a comment\n0 1f43\n1\t1f44 8fa40000 ignored\n \n2 404\n";
    TraceCounts counts;
    EXPECT_THAT(accesses(text, {TraceForm::din, false}, &counts),
                ElementsAre("r 1f40 10", "w 1f4f 1", "r 1f50 8", "r 1f40 4", "w 1f44 4"));
    EXPECT_EQ(counts.reads, 3U);
    EXPECT_EQ(counts.writes, 2U);
    EXPECT_EQ(counts.fetches, 2U);
    EXPECT_THAT(accesses("i 400 4\n2 404\r\n", {TraceForm::din, true}), ElementsAre("r 400 4", "r 404 4"));
}

TEST(TraceFile, ReadsLackeysLines) {
    const std::string text =
        "==12== Command: ./t\n==12== \nI  0401ab70,3\n S 1fff000708,8\n L 1fff000700,16\n M 5,1\n==12== Exit code: 0\n";
    TraceCounts counts;
    EXPECT_THAT(accesses(text, {TraceForm::lackey, false}, &counts),
                ElementsAre("w 1fff000708 8", "r 1fff000700 10", "r 5 1", "w 5 1"));
    EXPECT_EQ(counts.reads, 2U);
    EXPECT_EQ(counts.writes, 2U);
    EXPECT_EQ(counts.fetches, 1U);
    EXPECT_THAT(accesses("I  0401ab70,3\n", {TraceForm::lackey, true}), ElementsAre("r 401ab70 3"));
    EXPECT_THAT(accesses("I 10,3\n\nL 20,8\n  S  30,4 \n# a comment\n", {TraceForm::lackey, true}),
                ElementsAre("r 10 3", "r 20 8", "w 30 4"))
        << "with other blanks, as handouts have them";
}

TEST(TraceFile, FindsItsFormByItself) {
    const auto form = [](const std::string& text) {
        std::istringstream stream(text);
        return form_of(stream, "mine");
    };
    EXPECT_EQ(form("==1== Lackey\nI  0401ab70,3\n"), TraceForm::lackey);
    EXPECT_EQ(form(" M 5,1\n"), TraceForm::lackey);
    EXPECT_EQ(form("I 0401ab70,3\n"), TraceForm::lackey);
    EXPECT_EQ(form("\n# from simplescalar\n0 0401ab70\n"), TraceForm::din);
    EXPECT_EQ(form("i 0401ab70 3\n"), TraceForm::din);
    EXPECT_EQ(form("2 0401ab70\n"), TraceForm::din);
    EXPECT_THROW(static_cast<void>(form("")), std::runtime_error);
    EXPECT_THROW(static_cast<void>(form("==1== nothing else\n")), std::runtime_error);
    EXPECT_THROW(static_cast<void>(form("once upon a time\n")), std::runtime_error);
}

TEST(TraceFile, NamesTheLineThatIsNone) {
    for (const char* bad : {"x 10 8", "r", "r 10", "r 10,8", "r 10 0", "r 10 100001", "r zz 8", "r 10 8x",
                            "0", "0 10x", "00 10", "r 11111111111111111 8", "r ffffffffffffffff 2"}) {
        const std::string text = complaint("r 10 8\n" + std::string(bad) + "\n", TraceForm::din);
        EXPECT_THAT(text, testing::AllOf(testing::StartsWith("t:2: '" + std::string(bad) + "' wants "),
                                         HasSubstr("SIZE")))
            << bad;
    }
    for (const char* bad :
         {" L 10", " L 10,", " L 10,x", "L10,8", "LS 10,8", " L 10,8 x", " L ,8", " L 10,0", " X 10,8"}) {
        const std::string text = complaint("==1== a\n L 10,8\n" + std::string(bad) + "\n", TraceForm::lackey);
        EXPECT_THAT(text, testing::AllOf(testing::StartsWith("t:3: '" + std::string(bad) + "' wants "),
                                         HasSubstr("lackey")))
            << bad;
    }
    for (const char* command : {"3 10", "4 0", "c 10 8", "v 1f40 40"})
        EXPECT_THAT(
            complaint("r 10 8\n" + std::string(command) + "\n", TraceForm::din),
            testing::AllOf(HasSubstr("t:2: '" + std::string(command)), HasSubstr("delete such lines")));
    for (const char* sized : {"0 3019b6c8 2", "1 10 8", "2 400 10"})
        EXPECT_THAT(complaint("r 10 8\n" + std::string(sized) + "\n", TraceForm::din),
                    testing::AllOf(HasSubstr("t:2: '" + std::string(sized)), HasSubstr("no sizes")));
    EXPECT_EQ(complaint("r ffffffffffffffff 1", TraceForm::din), "");
}

/// Random accesses, some over lines: as the cells' own model has them in its first pass, and after a file.
TEST(TraceCaches, MissAsCellsDo) {
    const std::vector<CacheMachine> machines = described_machines({"pentium3_coppermine", "zen5"});
    std::ostringstream file;
    DinWriter writer(file);
    SceneCaches scene(machines, 1, 1);
    TraceFanOut both({&writer, &scene});
    std::mt19937_64 bits(1);
    for (int i = 0; i < 50000; ++i) {
        const std::uint64_t address = bits() % (std::uint64_t{1} << (8 + bits() % 13));
        both.on_access({address, static_cast<std::uint32_t>(1 + bits() % 40),
                        bits() % 4 == 0 ? AccessKind::write : AccessKind::read, 0, 0, TraceSide::table_a});
    }
    scene.start_steady();
    TraceCaches caches(machines);
    std::istringstream stream(file.str());
    static_cast<void>(read_trace(stream, "t", {}, [&](const FileAccess& access) { caches.access(access); }));
    EXPECT_EQ(caches.distinct_lines(), scene.lines().distinct);
    for (std::size_t i = 0; i < machines.size(); ++i) {
        const MachineMisses& first = scene.first()[i];
        std::vector<LevelMisses> wanted = first.caches;
        wanted.insert(wanted.end(), first.tlbs.begin(), first.tlbs.end());
        const std::vector<TraceCaches::Level> found = caches.levels(i);
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t level = 0; level < wanted.size(); ++level) {
            EXPECT_EQ(found[level].name, wanted[level].level);
            EXPECT_EQ(found[level].counts.accesses, wanted[level].accesses) << found[level].name;
            EXPECT_EQ(found[level].counts.misses, wanted[level].misses.all()) << found[level].name;
            EXPECT_GT(wanted[level].misses.all(), 0U);
        }
    }
}

/// Ten rounds over sixty lines that lie far apart: any smaller cache brings in all of them each time.
TEST(TraceCaches, HaveTheirKneeWhereTheTraceFits) {
    TraceCaches caches({});
    for (int round = 0; round < 10; ++round)
        for (std::uint64_t i = 0; i < 60; ++i)
            caches.access({0x1fff00000000 + i * 0x12345640, 4, AccessKind::read});
    EXPECT_EQ(caches.distinct_lines(), 60U);
    EXPECT_EQ(caches.knee_bytes(), 60 * 64U);
    EXPECT_EQ(caches.misses(60 * 64), 60U);
    EXPECT_EQ(caches.misses(59 * 64), 600U);
}

}  // namespace
}  // namespace edgewise::measure
