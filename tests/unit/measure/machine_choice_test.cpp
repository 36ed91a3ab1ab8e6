// SPDX-License-Identifier: MIT
//
// Machines chosen by name, by file, and the one at hand; what is said of bad ones.
#include "edgewise/measure/cache/machine_choice.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace edgewise::measure {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class MachineChoices : public testing::Test {
  protected:
    MachineChoices()
        : folder_(fs::temp_directory_path() / ("edgewise-machines-" + std::to_string(getpid()))) {
        fs::create_directories(folder_);
    }
    ~MachineChoices() override { fs::remove_all(folder_); }

    std::string file(const std::string& name, const std::string& text) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << text;
        return (folder_ / name).string();
    }
    static std::string complaint(const std::vector<std::string>& names) {
        try {
            static_cast<void>(choose_machines(names));
        } catch (const std::exception& problem) {
            return problem.what();
        }
        return {};
    }
    /// A cache as sysfs tells it.
    void add_cache(int index, const std::string& type, int level, const std::string& size, int ways) const {
        const std::string at = "sys/devices/system/cpu/cpu0/cache/index" + std::to_string(index) + "/";
        file(at + "type", type);
        file(at + "level", std::to_string(level));
        file(at + "size", size);
        file(at + "ways_of_associativity", std::to_string(ways));
        file(at + "coherency_line_size", "64");
    }

    fs::path folder_;
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
    EXPECT_THAT(complaint({(folder_ / "none.json").string()}), HasSubstr("none.json: no such file"));
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
    const auto host = host_machine(folder_);
    ASSERT_TRUE(host.value) << host.reason;
    ASSERT_EQ(host.value->caches.levels.size(), 2U);
    EXPECT_EQ(host.value->caches.levels[0].name, "L1D");
    EXPECT_EQ(host.value->caches.levels[0].sets, 64U);
    EXPECT_EQ(host.value->caches.levels[1].ways, 16U);
    EXPECT_FALSE(host.value->latencies_known());
}

/// As Linux tells of Intel's Lion Cove: 48K, then 192K, both of level 1.
TEST_F(MachineChoices, HaveLevelsOfDifferentNames) {
    add_cache(0, "Data", 1, "48K", 12);
    add_cache(1, "Data", 1, "192K", 12);
    add_cache(2, "Unified", 2, "3072K", 12);
    const auto host = host_machine(folder_);
    ASSERT_TRUE(host.value) << host.reason;
    std::vector<std::string> names;
    for (const LevelGeometry& level : host.value->caches.levels) names.push_back(level.name);
    EXPECT_THAT(names, testing::ElementsAre("L1D", "L1D_2", "L2"));
}

TEST_F(MachineChoices, SayWhenTheHostDoesNotTell) {
    EXPECT_FALSE(host_machine(folder_ / "nowhere").reason.empty());
    add_cache(0, "Instruction", 1, "32K", 8);
    EXPECT_THAT(host_machine(folder_).reason, HasSubstr("no data cache"));
    add_cache(0, "Data", 1, "48K", 0);
    EXPECT_FALSE(host_machine(folder_).value);
}

}  // namespace
}  // namespace edgewise::measure
