// SPDX-License-Identifier: MIT
//
// Machines chosen by name, by file, and this one; messages for bad ones.
#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "../complaint.hpp"
#include "../temporary_folder.hpp"
#include "edgewise/measure/cache/machine_choice.hpp"
#include "edgewise/measure/machine/machine.hpp"

namespace edgewise::measure {
namespace {

using testing::HasSubstr;

class MachineChoices : public testing::Test {
  protected:
    std::string file(const std::string& name, const std::string& text) const {
        return folder_.write(name, text);
    }
    static std::string complaint(const std::vector<std::string>& names) {
        return complaint_of<std::exception>([&] { return choose_machines(names); });
    }
    /// Writes the description of one cache, in the format of sysfs.
    void add_cache(int index, const std::string& type, int level, const std::string& size, int ways,
                   std::int64_t processor = 0) const {
        const std::string at = "sys/devices/system/cpu/cpu" + std::to_string(processor) + "/cache/index" +
                               std::to_string(index) + "/";
        file(at + "type", type);
        file(at + "level", std::to_string(level));
        file(at + "size", size);
        file(at + "ways_of_associativity", std::to_string(ways));
        file(at + "coherency_line_size", "64");
    }

    const TemporaryFolder folder_;
};

constexpr const char* good =
    R"({"what": "mine", "clock_mhz": 1000, "line_bytes": 64,
        "levels": [{"name": "L1D", "bytes": 32768, "ways": WAYS, "latency_cycles": 4, "source": "me"}],
        "memory": {"latency_cycles": 100, "source": "me"}})";

std::string with_ways(const std::string& ways) {
    std::string text = good;
    return text.replace(text.find("WAYS"), 4, ways);
}

TEST_F(MachineChoices, AreFoundByNameAndByFile) {
    const std::string mine = file("mine.json", with_ways("8"));
    const std::string names[] = {"zen5", mine};
    const auto chosen = choose_machines(names);
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_EQ(chosen[0].name, "zen5");
    EXPECT_EQ(chosen[1].name, "mine");
    ASSERT_TRUE(chosen[1].machine.value);
    EXPECT_EQ(chosen[1].machine.value->caches.levels[0].sets, 64U);
}

TEST_F(MachineChoices, AreRefusedWithOneLineThatSaysWhat) {
    EXPECT_THAT(complaint({"zen17"}), testing::AllOf(HasSubstr("zen17"), HasSubstr("pentium3_coppermine")));
    EXPECT_THAT(complaint({"zen5", "zen5"}), HasSubstr("two machines"));
    EXPECT_THAT(complaint({folder_ / "none.json"}), HasSubstr("none.json: no such file"));
    EXPECT_THAT(complaint({file("bad.json", with_ways("0"))}),
                testing::AllOf(HasSubstr("levels[0].ways"), HasSubstr("from 1 to 512")));
}

TEST_F(MachineChoices, UnderAnotherPolicyKeepTheirSizes) {
    const std::string names[] = {"zen5"};
    const CacheMachine plain = *choose_machines(names).front().machine.value;
    const CacheMachine other = with_policy(plain, Replacement::tree_plru);
    EXPECT_EQ(other.name, "zen5/tree_plru");
    for (std::size_t i = 0; i < other.caches.levels.size(); ++i) {
        EXPECT_EQ(other.caches.levels[i].replacement, Replacement::tree_plru);
        EXPECT_EQ(other.caches.levels[i].sets, plain.caches.levels[i].sets);
    }
}

TEST_F(MachineChoices, TakeTheHostFromSysfs) {
    add_cache(0, "Data", 1, "48K", 12);
    add_cache(1, "Instruction", 1, "32K", 8);
    add_cache(2, "Unified", 2, "1024K", 16);
    const auto host = host_machine(folder_.path());
    ASSERT_TRUE(host.value) << host.reason;
    ASSERT_EQ(host.value->caches.levels.size(), 2U);
    EXPECT_EQ(host.value->caches.levels[0].name, "L1D");
    EXPECT_EQ(host.value->caches.levels[0].sets, 64U);
    EXPECT_EQ(host.value->caches.levels[1].ways, 16U);
    EXPECT_FALSE(host.value->latencies_known());
}

/// The processors below and above it have other caches.
TEST_F(MachineChoices, TakeTheHostFromTheProcessorThatTheProcessMayRunOn) {
    const std::int64_t here = allowed_processors().at(0);
    for (const std::int64_t processor : {std::max(here - 1, std::int64_t{0}), here + 1, here})
        add_cache(0, "Data", 1, processor == here ? "32K" : "48K", processor == here ? 8 : 12, processor);
    const auto host = host_machine(folder_.path());
    ASSERT_TRUE(host.value) << host.reason;
    EXPECT_EQ(host.value->caches.levels[0].ways, 8U);
    EXPECT_EQ(host.value->what, "this machine, as the kernel reports it: processors " + std::to_string(here));
}

/// Linux reports two caches of level 1 for Intel's Lion Cove: 48K, then 192K.
TEST_F(MachineChoices, HaveLevelsOfDifferentNames) {
    add_cache(0, "Data", 1, "48K", 12);
    add_cache(1, "Data", 1, "192K", 12);
    add_cache(2, "Unified", 2, "3072K", 12);
    const auto host = host_machine(folder_.path());
    ASSERT_TRUE(host.value) << host.reason;
    std::vector<std::string> names;
    for (const LevelGeometry& level : host.value->caches.levels) names.push_back(level.name);
    EXPECT_THAT(names, testing::ElementsAre("L1D", "L1D_2", "L2"));
}

TEST_F(MachineChoices, SayWhenTheHostDoesNotTell) {
    EXPECT_FALSE(host_machine(folder_ / "nowhere").reason.empty());
    add_cache(0, "Instruction", 1, "32K", 8);
    EXPECT_THAT(host_machine(folder_.path()).reason, HasSubstr("no data cache"));
    add_cache(0, "Data", 1, "48K", 0);
    EXPECT_FALSE(host_machine(folder_.path()).value);
}

using testing::ElementsAre;

TEST(MachineOfSizes, ReadsSizes) {
    EXPECT_EQ(bytes_of_size("256K"), 262144U);
    EXPECT_EQ(bytes_of_size("8M"), 8U << 20);
    EXPECT_EQ(bytes_of_size("1g"), 1ULL << 30);
    EXPECT_EQ(bytes_of_size("256KiB"), 262144U);
    EXPECT_EQ(bytes_of_size("4096"), 4096U);
    for (const char* wrong :
         {"", "K", "0K", "256X", "-1K", "1.5M", "4096iB", "99999999999999999999", "9999999999G"})
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
        EXPECT_THAT(complaint_of<std::invalid_argument>([&] { return machine_of_sizes(wrong); }),
                    HasSubstr("l2=256K,l3=8M"))
            << wrong;
        EXPECT_THROW(static_cast<void>(machine_of_sizes(wrong)), std::invalid_argument);
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

/// A machine file needs only the data that a user knows: line size, and size and ways of each level.
TEST(MachineAsFile, NeedsNoMoreThanLevels) {
    const CacheMachine machine = parse_cache_machine(
        R"({"line_bytes": 64, "levels": [{"name": "L2", "bytes": 262144, "ways": 8}]})", "mine");
    EXPECT_EQ(machine.what, "mine");
    EXPECT_FALSE(machine.latencies_known());
}

}  // namespace

}  // namespace edgewise::measure
