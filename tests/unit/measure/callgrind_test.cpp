// SPDX-License-Identifier: MIT
//
// How Callgrind is asked and understood; what it finds is the crosscheck's.
#include "edgewise/measure/process/callgrind.hpp"

#include <gmock/gmock.h>

#include "edgewise/measure/process/child_process.hpp"

namespace edgewise::measure {
namespace {

using testing::Contains;
using testing::HasSubstr;

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

/// As Callgrind 3.19 wrote it: conditional branches and indirect ones, of which none were mispredicted.
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
