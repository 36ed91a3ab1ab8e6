// SPDX-License-Identifier: MIT
//
// How Callgrind's output is read instruction by instruction, on one written by hand after the specification
// of its format, and what addr2line says of inlined code.
#include <gmock/gmock.h>

#include <sstream>

#include "edgewise/measure/process/callgrind.hpp"
#include "edgewise/measure/process/child_process.hpp"

namespace edgewise::measure {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A program of main, which calls twice what copies, and a library's copy.
constexpr const char* by_hand = R"(# callgrind format
version: 1
creator: callgrind-3.19.0
cmd: ./program --x=1
desc: Trigger: Program termination

positions: instr line
events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw Bc Bcm Bi Bim
summary: 999 9

ob=(1) /bin/program
fl=(1) main.cpp
fn=(1) main
0x1000 10 7 1 0 0 1 1
+4 +2 3
fi=(2) vec.hpp
* -5 5 0 0 0 0 0 0 0 0 2 1 1 1
cob=(2) /lib/libc.so
cfi=(3) copy.c
cfn=(2) copy
calls=2 0x90 30
+12 +9 40 4 4 0 2
fe=(1)
-8 11 2

ob=(2)
fl=(3)
fn=(2)
0x90 30 20
+2 +1 20 4 4 0 2

totals: 57 5 4 0 3 1 0 0 0 2 1 1 1
)";

Expected<CallgrindLines> read_lines(const std::string& text) {
    std::istringstream stream(text);
    return parse_callgrind_lines(stream);
}

TEST(CallgrindLines, OwnCostsAddUpToTheTotal) {
    const auto read = read_lines(by_hand);
    ASSERT_TRUE(read.value) << read.reason;
    InstructionCost sum;
    for (const CallgrindLine& line : read.value->lines) sum += line.cost;
    EXPECT_EQ(sum, (InstructionCost{57, 2, 4}));
    EXPECT_EQ(sum, read.value->total);
}

TEST(CallgrindLines, PlacesAndNamesAreUnpacked) {
    const auto read = read_lines(by_hand);
    ASSERT_TRUE(read.value) << read.reason;
    const auto& [lines, calls, functions, objects, total] = *read.value;
    EXPECT_THAT(functions, ElementsAre("main", "copy"));
    EXPECT_THAT(objects, ElementsAre("/bin/program", "/lib/libc.so"));
    std::vector<std::uint64_t> addresses;
    for (const CallgrindLine& line : lines) addresses.push_back(line.address);
    EXPECT_THAT(addresses, ElementsAre(0x1000, 0x1004, 0x1004, 0x1008, 0x90, 0x92));
    EXPECT_EQ(lines[3].object, 0U);
    EXPECT_EQ(lines[4].object, 1U);
    EXPECT_EQ(lines[4].function, 1U);
    ASSERT_EQ(calls.size(), 1U);
    EXPECT_EQ(calls[0].from.address, 0x1010U);
    EXPECT_EQ(calls[0].from.function, 0U);
    EXPECT_EQ(calls[0].callee, 1U);
    EXPECT_EQ(calls[0].from.cost, (InstructionCost{40, 0, 2}));
}

TEST(CallgrindLines, WhatIsMissingIsSaid) {
    std::string text = by_hand;
    EXPECT_THAT(read_lines("positions: line\n" + text.substr(text.find("events"))).reason,
                HasSubstr("addresses"));
    EXPECT_THAT(read_lines(text.substr(0, text.find("totals"))).reason, HasSubstr("total"));
    EXPECT_THAT(read_lines("events: Ir\n").reason, HasSubstr("D1mr"));
    EXPECT_THAT(read_lines(text + "0x12z 3 4\n").reason, HasSubstr("0x12z"));
    EXPECT_FALSE(read_lines("").value);
}

TEST(InlineFrames, AreReadFromTheInnermostOutwards) {
    const InlineFrames frames = parse_inline_frames(
        "0x0000000000001000\n"
        "edgewise::dot<double>(Vec<double> const&)\n/e/src/edgewise/geometry/vec.hpp:40\n"
        "double edgewise::climb<edgewise::T<int>, Q>(edgewise::T<int> const&) const\n/e/support.hpp:7 "
        "(discriminator 2)\n"
        "0x0000000000001004\n??\n??:0\n");
    ASSERT_EQ(frames.size(), 2U);
    const auto& first = frames.at(0x1000);
    ASSERT_EQ(first.size(), 2U);
    EXPECT_EQ(first[0].function, "dot");
    EXPECT_EQ(first[0].file, "/e/src/edgewise/geometry/vec.hpp");
    EXPECT_EQ(first[1].function, "climb");
    EXPECT_EQ(first[1].file, "/e/support.hpp");
    EXPECT_EQ(frames.at(0x1004)[0].file, "??");
}

TEST(InlineFrames, FunctionsAreToldByTheirPlainNames) {
    EXPECT_EQ(plain_function_name("edgewise::GjkRun<edgewise::aos<P, D>, T>::advance(double)"), "advance");
    EXPECT_EQ(plain_function_name("(anonymous namespace)::run(edgewise::Pass const&)"), "run");
    EXPECT_EQ(plain_function_name("edgewise::f<T>(T)::{lambda(T<int>)#1}::operator()(T) const"), "f");
    EXPECT_EQ(plain_function_name("main"), "main");
}

using testing::Contains;

const CacheMachine& machine(const std::string& name) {
    for (const CacheMachine& known : cache_machines()) {
        if (known.name == name) return known;
    }
    throw std::invalid_argument(name);
}

TEST(Callgrind, IsGivenTheGeometry) {
    const auto geometry = callgrind_geometry(machine("pentium3_coppermine"));
    ASSERT_TRUE(geometry.value) << geometry.reason;
    const auto command = callgrind_command(*geometry.value, "out", {"program", "word"});
    EXPECT_THAT(command, Contains("--D1=16384,4,32"));
    EXPECT_THAT(command, Contains("--LL=262144,8,32"));
    EXPECT_THAT(command, Contains("--cache-sim=yes"));
    EXPECT_THAT(command, Contains("--branch-sim=yes"));
    EXPECT_EQ(command.back(), "word");
}

TEST(Callgrind, IsNotAskedForWhatItCannotSimulate) {
    CacheMachine odd = machine("zen5");
    odd.caches.levels[1].sets = 1000;
    EXPECT_THAT(callgrind_geometry(odd).reason, HasSubstr("power of two"));
    odd.caches.levels.resize(1);
    EXPECT_THAT(callgrind_geometry(odd).reason, HasSubstr("two levels"));
}

/// Zeros at the end of a total are left out.
TEST(Callgrind, IsReadWithItsTrailingZeros) {
    const auto counts =
        parse_callgrind("events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\nfn=f\n1 2\ntotals: 1284 257 1\n");
    ASSERT_TRUE(counts.value) << counts.reason;
    EXPECT_EQ(counts.value->instructions, 1284);
    EXPECT_EQ(counts.value->accesses, 258);
    EXPECT_EQ(counts.value->d1_misses, 0);
    EXPECT_EQ(counts.value->ll_misses, 0);
    EXPECT_THAT(parse_callgrind("events: Ir\ntotals: 5\n").reason, HasSubstr("Dr"));
    EXPECT_FALSE(parse_callgrind("").value);
}

/// Output of Callgrind 3.19: conditional branches, and indirect branches without a misprediction.
TEST(Callgrind, IsReadWithItsBranches) {
    const auto counts = parse_callgrind(
        "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw Bc Bcm Bi Bim\n"
        "summary: 803739 173805 88539 580 932 61 3 1 0 57234 6956 317\n\n"
        "totals: 803730 173805 88533 578 932 61 2 1 0 57234 6956 317\n");
    ASSERT_TRUE(counts.value) << counts.reason;
    EXPECT_EQ(counts.value->instructions, 803730);
    EXPECT_EQ(counts.value->d1_misses, 993);
    EXPECT_EQ(counts.value->mispredictions, 6956);
    const auto indirect = parse_callgrind(
        "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw Bc Bcm Bi Bim\ntotals: 9 0 0 0 0 0 0 0 0 5 2 4 3\n");
    EXPECT_EQ(indirect.value.value().mispredictions, 5);
    const auto without = parse_callgrind("events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw\ntotals: 9 1 1\n");
    EXPECT_FALSE(without.value.value().mispredictions) << "no branches were simulated: not none missed";
}

TEST(ChildProcess, TellsWhatAProgramSaid) {
    const auto both = run_program({"sh", "-c", "echo out; echo err >&2; exit 3"});
    ASSERT_TRUE(both.value) << both.reason;
    EXPECT_EQ(both.value->out, "out\n");
    EXPECT_EQ(both.value->err, "err\n");
    EXPECT_EQ(both.value->exit_code, 3);
    const auto ended = run_program({"sh", "-c", "kill -9 $$"});
    ASSERT_TRUE(ended.value);
    EXPECT_EQ(ended.value->exit_code, 128 + 9);
    EXPECT_THAT(run_program({"no-such-program-anywhere"}).reason, HasSubstr("no-such-program-anywhere"));
}

}  // namespace

}  // namespace edgewise::measure
