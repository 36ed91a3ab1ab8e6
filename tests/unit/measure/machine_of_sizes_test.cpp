// SPDX-License-Identifier: MIT
//
// Machines from sizes, and machines as files: what is printed is read back as the same machine.
#include "edgewise/measure/cache/machine_of_sizes.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "edgewise/measure/cache/machine_choice.hpp"

namespace edgewise::measure {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(MachineOfSizes, ReadsSizes) {
    EXPECT_EQ(bytes_of_size("256K"), 262144U);
    EXPECT_EQ(bytes_of_size("8M"), 8U << 20);
    EXPECT_EQ(bytes_of_size("1g"), 1ULL << 30);
    EXPECT_EQ(bytes_of_size("256KiB"), 262144U);
    EXPECT_EQ(bytes_of_size("4096"), 4096U);
    for (const char* wrong : {"", "K", "0K", "256X", "-1K", "1.5M", "99999999999999999999", "9999999999G"})
        EXPECT_EQ(bytes_of_size(wrong), std::nullopt) << wrong;
}

TEST(MachineOfSizes, JoinsLevelsThatCommasTookApart) {
    const std::vector<std::string> apart = {"zen5", "l2=256K", "l3=8M", "l1=16K", "host", "l2=1M"};
    EXPECT_THAT(joined_level_sizes(apart), ElementsAre("zen5", "l2=256K,l3=8M", "l1=16K", "host", "l2=1M"));
    const std::vector<std::string> together = {"l2=256K,l3=8M", "l4=64M"};
    EXPECT_THAT(joined_level_sizes(together), ElementsAre("l2=256K,l3=8M,l4=64M"));
}

TEST(MachineOfSizes, HasTheLevelsAskedFor) {
    const std::vector<std::string> names = {"l2=256K", "l3=12M"};
    const auto chosen = choose_machines(names);
    ASSERT_EQ(chosen.size(), 1U);
    const CacheMachine& machine = *chosen.front().machine.value;
    EXPECT_EQ(machine.name, "l2_256K_l3_12M");
    ASSERT_EQ(machine.caches.levels.size(), 3U) << "a first level is always there";
    const std::uint64_t bytes[] = {32 << 10, 256 << 10, 12 << 20};
    for (std::size_t i = 0; i < 3; ++i) {
        const LevelGeometry& level = machine.caches.levels[i];
        EXPECT_EQ(std::uint64_t{level.sets} * level.ways * machine.caches.line_bytes, bytes[i]);
    }
    EXPECT_FALSE(machine.latencies_known()) << "sizes say nothing of time";
    EXPECT_EQ(machine_of_sizes("l2=16K").caches.levels[0].sets * 8 * 64U, 16384U)
        << "no first level larger than the second";
}

TEST(MachineOfSizes, RefusesWhatIsNone) {
    for (const char* wrong :
         {"l2=256X", "l3=8M,l2=256K", "l2=256K,l2=1M", "l2=100", "l2=1000001", "l2=8M,x"}) {
        try {
            static_cast<void>(machine_of_sizes(wrong));
            FAIL() << wrong;
        } catch (const std::invalid_argument& problem) {
            EXPECT_THAT(problem.what(), HasSubstr("l2=256K,l3=8M")) << wrong;
        }
    }
}

void expect_same(const CacheGeometry& a, const CacheGeometry& b) {
    EXPECT_EQ(a.line_bytes, b.line_bytes);
    ASSERT_EQ(a.levels.size(), b.levels.size());
    for (std::size_t i = 0; i < a.levels.size(); ++i) {
        EXPECT_EQ(a.levels[i].name, b.levels[i].name);
        EXPECT_EQ(a.levels[i].sets, b.levels[i].sets);
        EXPECT_EQ(a.levels[i].ways, b.levels[i].ways);
        EXPECT_EQ(a.levels[i].inclusion, b.levels[i].inclusion);
        EXPECT_EQ(a.levels[i].replacement, b.levels[i].replacement);
    }
}

TEST(MachineAsFile, IsReadBackAsTheSame) {
    std::vector<CacheMachine> machines = cache_machines();
    machines.push_back(machine_of_sizes("l2=256K,l3=8M"));
    for (const CacheMachine& machine : machines) {
        const CacheMachine back = parse_cache_machine(cache_machine_json(machine), machine.name);
        EXPECT_EQ(back.what, machine.what);
        EXPECT_EQ(back.clock_mhz, machine.clock_mhz) << machine.name;
        EXPECT_EQ(back.latencies_known(), machine.latencies_known()) << machine.name;
        EXPECT_EQ(back.memory.latency_cycles, machine.memory.latency_cycles);
        expect_same(back.caches, machine.caches);
        expect_same(back.tlbs, machine.tlbs);
        for (std::size_t i = 0; i < machine.origins.size(); ++i) {
            EXPECT_EQ(back.origins[i].latency_cycles, machine.origins[i].latency_cycles) << machine.name;
            EXPECT_EQ(back.origins[i].source, machine.origins[i].source);
            EXPECT_EQ(back.origins[i].proves("latency_cycles"), machine.origins[i].proves("latency_cycles"));
        }
    }
}

/// What a user knows of a machine is enough: sizes and ways.
TEST(MachineAsFile, NeedsNoMoreThanLevels) {
    const CacheMachine machine = parse_cache_machine(
        R"({"line_bytes": 64, "levels": [{"name": "L2", "bytes": 262144, "ways": 8}]})", "mine");
    EXPECT_EQ(machine.what, "mine");
    EXPECT_FALSE(machine.latencies_known());
}

}  // namespace
}  // namespace edgewise::measure
