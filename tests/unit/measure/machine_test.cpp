// SPDX-License-Identifier: MIT
//
// The machine: parsers against texts of other machines, the whole against a made-up /proc and /sys and
// against what the system calls of this machine say; nothing unknown turns into a number.
#include "edgewise/measure/machine/machine.hpp"

#include <gtest/gtest.h>
#include <sys/sysinfo.h>
#include <unistd.h>

#include <set>
#include <string>
#include <vector>

#include "../temporary_folder.hpp"
#include "edgewise/measure/machine/machine_json.hpp"

namespace edgewise::measure {
namespace {

using nlohmann::json;

constexpr const char* intel_cpuinfo = R"(processor	: 0
vendor_id	: GenuineIntel
cpu family	: 6
model		: 85
model name	: Intel(R) Xeon(R) Gold 6130 CPU @ 2.10GHz
stepping	: 4
physical id	: 0
core id		: 0
flags		: fpu sse2 ssse3 sse4_1 avx avx2 fma avx512f xavx512bw

processor	: 1
vendor_id	: GenuineIntel
physical id	: 0
core id		: 0
flags		: fpu sse2

processor	: 2
physical id	: 1
core id		: 0
)";

constexpr const char* arm_cpuinfo = R"(processor	: 0
BogoMIPS	: 243.75
Features	: fp asimd evtstrm aes asimdhp sve
CPU implementer	: 0x41
CPU architecture: 8
CPU variant	: 0x1
CPU part	: 0xd40
CPU revision	: 1

processor	: 1
CPU implementer	: 0x41

Hardware	: some board
)";

TEST(Numbers, AreWholeOrNothing) {
    EXPECT_EQ(parse_number("0"), 0);
    EXPECT_EQ(parse_number("48K"), 48 * 1024);
    EXPECT_EQ(parse_number("3M"), 3 * 1024 * 1024);
    EXPECT_EQ(parse_number("2G"), std::int64_t{2} << 30);
    EXPECT_EQ(parse_number("-1"), -1);
    EXPECT_EQ(parse_number("0xd40"), 0xd40);
    for (const char* text : {"", "K", "0x", "12 KB", "1.5", "x", "99999999999999999999", " 1"}) {
        EXPECT_FALSE(parse_number(text)) << text;
    }
}

TEST(Cpu, ReadsIntel) {
    const Cpu cpu = parse_cpu(intel_cpuinfo);
    EXPECT_EQ(cpu.vendor.value, "GenuineIntel");
    EXPECT_EQ(cpu.name.value, "Intel(R) Xeon(R) Gold 6130 CPU @ 2.10GHz");
    EXPECT_EQ(cpu.family.value, 6);
    EXPECT_EQ(cpu.model.value, 85);
    EXPECT_EQ(cpu.stepping.value, 4);
    EXPECT_EQ(cpu.cores.value, 2);  // two threads of one core, and a core 0 in another package
    EXPECT_EQ(cpu.threads, 3);
    EXPECT_EQ(cpu.hypervisor.value, false);
    EXPECT_EQ(cpu.vector_extensions,
              (std::vector<std::string>{"sse2", "ssse3", "sse4_1", "avx", "avx2", "fma", "avx512f"}));
}

TEST(Cpu, ReadsArm) {
    const Cpu cpu = parse_cpu(arm_cpuinfo);
    EXPECT_EQ(cpu.vendor.value, "0x41");
    EXPECT_EQ(cpu.family.value, 8);
    EXPECT_EQ(cpu.model.value, 0xd40);
    EXPECT_EQ(cpu.stepping.value, 1);
    EXPECT_EQ(cpu.threads, 2);
    EXPECT_EQ(cpu.vector_extensions, (std::vector<std::string>{"asimd", "asimdhp", "sve"}));
    for (const std::string& reason : {cpu.name.reason, cpu.cores.reason, cpu.hypervisor.reason}) {
        EXPECT_FALSE(reason.empty());
    }
    EXPECT_FALSE(cpu.name.value || cpu.cores.value || cpu.hypervisor.value);
}

TEST(Cpu, IsTheNamedProcessor) {
    EXPECT_EQ(parse_cpu(intel_cpuinfo, 1).vector_extensions, std::vector<std::string>{"sse2"});
    EXPECT_EQ(parse_cpu(intel_cpuinfo, 9).model.value, 85) << "the first where that one is not listed";
    EXPECT_EQ(parse_cpu(intel_cpuinfo, 1).threads, 3);
}

TEST(Cpu, KnowsNothingFromNothing) {
    const Cpu cpu = parse_cpu("garbage\n: :\n");
    EXPECT_FALSE(cpu.vendor.value || cpu.family.value || cpu.cores.value || cpu.hypervisor.value);
    EXPECT_FALSE(cpu.vendor.reason.empty() || cpu.cores.reason.empty());
    EXPECT_EQ(cpu.threads, 0);
}

/// A made-up file system root, gone afterwards.
class MachineTest : public testing::Test {
  protected:
    void write(const std::string& file, const std::string& text) const { folder_.write(file, text + '\n'); }
    void write_cache(int index, const char* level, const char* type, const char* size, const char* ways,
                     int processor = 0, const std::string& shared_by = "0-3") const {
        const std::string directory = "sys/devices/system/cpu/cpu" + std::to_string(processor) +
                                      "/cache/index" + std::to_string(index) + "/";
        write(directory + "level", level);
        write(directory + "type", type);
        write(directory + "size", size);
        write(directory + "ways_of_associativity", ways);
        write(directory + "coherency_line_size", "64");
        write(directory + "shared_cpu_list", shared_by);
    }
    /// An i9-12900K as Linux describes it: 8 cores of 2 threads, and 8 small cores, which share an L2 by
    /// four.
    void write_hybrid() const {
        for (int i = 0; i < 24; ++i) {
            const bool large = i < 16;
            const auto shared = [i](int threads) {
                return std::to_string(i / threads * threads) +
                       (threads > 1 ? "-" + std::to_string(i / threads * threads + threads - 1) : "");
            };
            write_cache(0, "1", "Data", large ? "48K" : "32K", large ? "12" : "8", i, shared(large ? 2 : 1));
            write_cache(1, "1", "Instruction", large ? "32K" : "64K", "8", i, shared(large ? 2 : 1));
            write_cache(2, "2", "Unified", large ? "1280K" : "2048K", large ? "10" : "16", i,
                        shared(large ? 2 : 4));
            write_cache(3, "3", "Unified", "30720K", "12", i, "0-23");
            write("sys/devices/system/cpu/cpu" + std::to_string(i) + "/cpufreq/scaling_governor",
                  large ? "performance" : "powersave");
        }
        write("sys/devices/system/cpu/cpufreq/boost", "1");  // further folders whose names begin with cpu
        write("sys/devices/system/cpu/cpuidle/current_driver", "intel_idle");
    }
    [[nodiscard]] std::vector<CoreKind> cores(const std::vector<std::int64_t>& allowed) const {
        return read_cores(root_, allowed).value.value_or(std::vector<CoreKind>());
    }
    void write_machine() const {
        write("proc/cpuinfo", intel_cpuinfo);
        write("proc/meminfo", "MemFree:  7 kB\nMemTotal:       1024 kB\nMemAvailable: 9 kB");
        write("proc/sys/kernel/osrelease", "6.1.0-x");
        write("proc/sys/kernel/randomize_va_space", "1");
        write("proc/sys/kernel/perf_event_paranoid", "-1");
        write("sys/kernel/mm/transparent_hugepage/enabled", "always madvise [never]");
        write("sys/devices/system/cpu/cpu0/cpufreq/scaling_governor", "performance");
        write("sys/devices/system/cpu/intel_pstate/no_turbo", "1");
        write("sys/devices/system/clocksource/clocksource0/current_clocksource", "hpet");
        write_cache(0, "1", "Data", "48K", "12");
        write_cache(1, "3", "Unified", "32768K", "0");
    }

    const TemporaryFolder folder_;
    const std::filesystem::path& root_ = folder_.path();
};

TEST_F(MachineTest, ReadsAMadeUpMachine) {
    write_machine();
    const Machine machine = read_machine(root_);
    EXPECT_EQ(machine.memory_bytes.value, 1024 * 1024);
    EXPECT_EQ(machine.kernel.value, "6.1.0-x");
    EXPECT_EQ(machine.aslr.value, 1);
    EXPECT_EQ(machine.perf_event_paranoid.value, -1);
    EXPECT_EQ(machine.transparent_huge_pages.value, "never");
    EXPECT_EQ(machine.governor.value, "performance");
    EXPECT_EQ(machine.turbo.value, false);
    EXPECT_EQ(machine.clock_source.value, "hpet");
    ASSERT_TRUE(machine.cores.value);
    ASSERT_EQ(machine.cores.value->size(), 1u);
    const std::vector<Cache>& caches = machine.cores.value->front().caches;
    ASSERT_EQ(caches.size(), 2u);
    const Cache& first = caches[0];
    EXPECT_EQ(first.level.value, 1);
    EXPECT_EQ(first.type.value, "Data");
    EXPECT_EQ(first.bytes.value, 49152);
    EXPECT_EQ(first.ways.value, 12);
    EXPECT_EQ(first.line_bytes.value, 64);
    EXPECT_EQ(first.shared_cpus.value, "0-3");
    EXPECT_FALSE(first.sets.value);      // no such file
    EXPECT_FALSE(caches[1].ways.value);  // 0 means that the kernel does not know
}

TEST_F(MachineTest, WritesAMadeUpMachineAsJson) {
    write_machine();
    const json j = machine_json(read_machine(root_), {});
    EXPECT_EQ(j["cpu"]["model"], 85);
    EXPECT_EQ(j["caches"][0]["bytes"], 49152);
    EXPECT_TRUE(j["caches"][0]["sets"].is_null());
    EXPECT_TRUE(j["unreadable"].contains("caches[0].sets"));
    EXPECT_TRUE(j["unreadable"].contains("caches[1].ways"));
    EXPECT_EQ(j["turbo"], false);
    EXPECT_FALSE(j["unreadable"].contains("turbo"));
}

TEST_F(MachineTest, TheHostIsTheKindOfCoresThatTheProcessIsBoundTo) {
    write_hybrid();
    const auto first_of = [&](const std::vector<std::int64_t>& allowed) {
        const std::vector<CoreKind> kinds = cores(allowed);
        EXPECT_EQ(kinds.size(), 2u);
        return kinds.front();
    };
    for (const std::vector<std::int64_t>& allowed : {std::vector<std::int64_t>{20}, {17, 18, 23}}) {
        const CoreKind small = first_of(allowed);
        EXPECT_EQ(processor_list(small.processors), "16-23");
        EXPECT_EQ(small.allowed, allowed);
        EXPECT_EQ(small.caches[0].bytes.value, 32 * 1024);
        EXPECT_EQ(small.shared_by[2], (std::set<std::string>{"16-19", "20-23"}));
        EXPECT_EQ(binding_advice(cores(allowed)), "bound to cores of one kind, 16-23; host has their caches");
    }
    for (const std::vector<std::int64_t>& allowed : {std::vector<std::int64_t>{3}, {15, 16}, {}}) {
        const CoreKind large = first_of(allowed);
        EXPECT_EQ(processor_list(large.processors), "0-15");
        EXPECT_EQ(large.caches[2].bytes.value, 1280 * 1024);
    }
    EXPECT_EQ(
        binding_advice(cores({15, 16})),
        "bound to no kind of cores, so times mix several; host has the caches of 0-15; to measure these: "
        "taskset -c 0-15");
    std::filesystem::remove_all(root_ / "sys/devices/system/cpu/cpu3");
    EXPECT_EQ(processor_list(first_of({3, 20}).processors), "16-23") << "of the first that is described";
}

/// The topology as the program prints it; and the facts of a processor that this process may run on.
TEST_F(MachineTest, DrawsTheTopologyOfAHybridMachine) {
    write_hybrid();
    Machine machine = read_machine(root_);
    EXPECT_EQ(machine.governor.value, allowed_processors().front() < 16 ? "performance" : "powersave");
    machine.cores = {cores({17})};
    const json j = machine_json(machine, {});
    EXPECT_EQ(j["cores"][0], json({{"processors", "16-23"},
                                   {"allowed", "17"},
                                   {"caches", "8 x L1D 32K, 8 x L1I 64K, 2 x L2 2M, L3 30M of 0-23"},
                                   {"bind", "taskset -c 16-23"}}));
    EXPECT_EQ(j["cores"][1]["caches"], "8 x L1D 48K, 8 x L1I 32K, 8 x L2 1280K, L3 30M of 0-23");
    EXPECT_EQ(j["cores"][1]["allowed"], "");
    EXPECT_EQ(j["caches"][2]["bytes"], 2048 * 1024);
    machine.cores = {cores({18, 20})};
    EXPECT_EQ(machine_identity(machine_json(machine, {})), machine_identity(j)) << "another core of the kind";
    machine.cores = {cores({2})};
    EXPECT_NE(machine_identity(machine_json(machine, {})), machine_identity(j));
}

TEST(Processors, AreListedAsTasksetTakesThem) {
    EXPECT_EQ(processor_list(std::vector<std::int64_t>{}), "");
    EXPECT_EQ(processor_list(std::vector<std::int64_t>{7}), "7");
    EXPECT_EQ(processor_list(std::vector<std::int64_t>{0, 1, 2, 4, 6, 7}), "0-2,4,6-7");
}

TEST_F(MachineTest, BoostIsTheOtherSwitch) {
    write("sys/devices/system/cpu/cpufreq/boost", "1");
    EXPECT_EQ(read_machine(root_).turbo.value, true);
}

TEST_F(MachineTest, NothingReadableMeansNullsWithReasons) {
    const json j = machine_json(read_machine(root_), {});
    for (const char* key : {"memory_bytes", "kernel", "hypervisor", "clock_source", "governor", "turbo",
                            "aslr", "transparent_huge_pages", "perf_event_paranoid"}) {
        ASSERT_TRUE(j.contains(key)) << key;
        EXPECT_TRUE(j[key].is_null()) << key;
        ASSERT_TRUE(j["unreadable"].contains(key)) << key;
        EXPECT_FALSE(j["unreadable"][key].get<std::string>().empty()) << key;
    }
    for (const char* key : {"vendor", "name", "family", "model", "stepping", "cores", "threads"}) {
        EXPECT_TRUE(j["cpu"][key].is_null()) << key;
        EXPECT_TRUE(j["unreadable"].contains(std::string("cpu.") + key)) << key;
    }
    EXPECT_TRUE(j["caches"].empty());
    EXPECT_TRUE(j["unreadable"].contains("caches"));
    EXPECT_TRUE(j["binding"].is_null() && j["unreadable"].contains("binding"));
}

TEST(Machine, AgreesWithTheSystemCallsHere) {
    const Machine machine = read_machine();
    EXPECT_EQ(machine.page_bytes.value, getpagesize());
    if (machine.memory_bytes.value) {
        struct sysinfo info {};
        ASSERT_EQ(sysinfo(&info), 0);
        EXPECT_EQ(*machine.memory_bytes.value, static_cast<std::int64_t>(info.totalram * info.mem_unit));
    }
    if (machine.cpu.cores.value) {
        EXPECT_GE(machine.cpu.threads, *machine.cpu.cores.value);
        EXPECT_LE(machine.cpu.threads, sysconf(_SC_NPROCESSORS_CONF));
    }
    const std::vector<std::int64_t> allowed = allowed_processors();
    EXPECT_GE(allowed.size(), 1u);
    EXPECT_LE(static_cast<std::int64_t>(allowed.size()), sysconf(_SC_NPROCESSORS_CONF));
}

TEST(Machine, IdentityIsTheSameInEveryRun) {
    const json first = machine_json();
    const json second = machine_json();
    EXPECT_EQ(machine_identity(first), machine_identity(second));
    json other = first;
    other["cpu"]["name"] = "another";
    EXPECT_NE(machine_identity(first), machine_identity(other));
    json recounted = first;
    for (json& counter : recounted["counters"]) counter["value"] = 123;
    EXPECT_EQ(machine_identity(first), machine_identity(recounted));
}

}  // namespace
}  // namespace edgewise::measure
