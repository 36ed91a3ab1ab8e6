// SPDX-License-Identifier: MIT
//
// Compares the cache model with Callgrind, which is independent of it, on kernels with known accesses and on
// old and new caches. Callgrind also has instructions and the stack in its last level, so it has a few misses
// more there.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdio>
#include <map>
#include <ostream>
#include <sstream>

#include "crosscheck_paths.hpp"
#include "edgewise/measure/process/callgrind.hpp"
#include "program.hpp"

namespace edgewise {
namespace {

using namespace cli_test;

struct Geometry {
    const char* name;
    unsigned line, d1_bytes, d1_ways, ll_bytes, ll_ways;
};

void PrintTo(const Geometry& geometry, std::ostream* out) { *out << geometry.name; }

/// Counts of a kernel, by the model or by the tool.
struct Counted {
    double accesses = 0, d1 = 0, ll = 0;
};

using Kernels = std::map<std::string, Counted>;

Kernels modelled(const std::string& printed) {
    Kernels kernels;
    std::istringstream lines(printed);
    std::string name;
    for (Counted c; lines >> name >> c.accesses >> c.d1 >> c.ll;) kernels[name] = c;
    return kernels;
}

/// Counts of one dump.
Counted counted_in(const std::string& dump) {
    const auto counts = measure::parse_callgrind(dump).value;
    EXPECT_TRUE(counts) << dump;
    return counts ? Counted{counts->accesses, counts->d1_misses, counts->ll_misses} : Counted();
}

/// Counts of all dumps in a folder, by the label that each kernel gave its dump.
Kernels counted(const Folder& folder) {
    Kernels kernels;
    for (const auto& file : std::filesystem::directory_iterator(folder.path())) {
        if (file.path().filename().string().rfind("callgrind.out", 0) != 0) continue;
        const std::string dump = text_of(file.path());
        const std::string mark = "desc: Trigger: Client Request: ";
        const std::size_t at = dump.find(mark);
        if (at == std::string::npos) continue;
        const std::string label = dump.substr(at + mark.size(), dump.find('\n', at) - at - mark.size());
        kernels[label] = counted_in(dump);
    }
    return kernels;
}

class Crosscheck : public testing::TestWithParam<Geometry> {};

TEST_P(Crosscheck, TheModelMissesWhatCallgrindMisses) {
    const Geometry& g = GetParam();
    const Folder folder;
    const auto option = [&](const char* name, unsigned bytes, unsigned ways) {
        return fmt::format("--{}={},{},{}", name, bytes, ways, g.line);
    };
    const auto text = [](unsigned value) { return std::to_string(value); };
    Process process(
        valgrind,
        {"--tool=callgrind", "--cache-sim=yes", option("I1", 32768, 8), option("D1", g.d1_bytes, g.d1_ways),
         option("LL", g.ll_bytes, g.ll_ways), "--instr-atstart=no", "--callgrind-out-file=callgrind.out",
         kernels_program, text(g.line), text(g.d1_bytes), text(g.d1_ways), text(g.ll_bytes), text(g.ll_ways)},
        folder);
    const Outcome outcome = process.wait();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Kernels ours = modelled(outcome.out), theirs = counted(folder);
    ASSERT_EQ(ours.size(), 15U) << outcome.out;
    double worst_d1 = 0, worst_ll = 0, most = 0;
    for (const auto& [name, model] : ours) {
        SCOPED_TRACE(name);
        ASSERT_TRUE(theirs.count(name));
        const Counted tool = theirs.at(name);
        EXPECT_NEAR(model.accesses, tool.accesses, 10);
        EXPECT_NEAR(model.d1, tool.d1, 10 + 1e-4 * model.d1);
        EXPECT_NEAR(model.ll, tool.ll, 10 + 1e-4 * model.ll);
        worst_d1 = std::max(worst_d1, std::abs(model.d1 - tool.d1));
        worst_ll = std::max(worst_ll, std::abs(model.ll - tool.ll));
        most = std::max(most, model.d1);
    }
    EXPECT_GT(most, 1000) << "no kernel misses: nothing was compared";
    std::printf("%s: %zu kernels, to %.0f misses; D1 differs by %.0f at most, LL by %.0f\n", g.name,
                ours.size(), most, worst_d1, worst_ll);
}

constexpr unsigned K = 1024, M = K * K;
INSTANTIATE_TEST_SUITE_P(
    On, Crosscheck,
    testing::Values(Geometry{"PentiumIIIKatmai", 32, 16 * K, 4, 512 * K, 4},
                    Geometry{"PentiumIIICoppermine", 32, 16 * K, 4, 256 * K, 8},
                    Geometry{"Small", 64, 16 * K, 4, 256 * K, 8}, Geometry{"K7", 64, 64 * K, 2, 512 * K, 2},
                    Geometry{"K7Thunderbird", 64, 64 * K, 2, 256 * K, 16},
                    Geometry{"Skylake", 64, 32 * K, 8, M, 16}, Geometry{"Zen2", 64, 32 * K, 8, 512 * K, 8},
                    Geometry{"Zen5", 64, 48 * K, 12, M, 16},
                    Geometry{"SapphireRapids", 64, 48 * K, 12, 2 * M, 16},
                    Geometry{"CortexA72", 64, 32 * K, 2, M, 16}, Geometry{"Direct", 64, 8 * K, 1, 128 * K, 1},
                    Geometry{"LongLines", 128, 64 * K, 8, 512 * K, 8}),
    [](const auto& geometry) { return std::string(geometry.param.name); });

Outcome under_valgrind(const Arguments& options, const Folder& folder) {
    Arguments all = options;
    all.emplace_back("/bin/true");
    Process process(valgrind, all, folder);
    return process.wait();
}

/// Compares the model of a program's whole trace by lackey with Cachegrind's run of the program. The two
/// processes have different addresses. Cachegrind counts a modified word as a read only, and one miss if a
/// reference crosses two lines.
TEST(Lackey, IsModelledAsCachegrindModelsTheProgram) {
    const Folder folder;
    ASSERT_EQ(under_valgrind({"--tool=lackey", "--trace-mem=yes", "--log-file=t.lackey"}, folder).exit_code,
              0);
    ASSERT_EQ(under_valgrind({"--tool=cachegrind", "--cache-sim=yes", "--I1=32768,8,64", "--D1=16384,4,64",
                              "--LL=262144,16,64", "--cachegrind-out-file=t.cachegrind"},
                             folder)
                  .exit_code,
              0);
    const Counted theirs = counted_in(text_of(folder / "t.cachegrind"));
    folder.write("both.json", R"({"what": "of both", "clock_mhz": 1, "line_bytes": 64, "levels": [
        {"name": "D1", "bytes": 16384, "ways": 4, "latency_cycles": 1, "source": "made up"},
        {"name": "LL", "bytes": 262144, "ways": 16, "latency_cycles": 1, "source": "made up"}],
        "memory": {"latency_cycles": 1, "source": "made up"}})");
    const Outcome ours = run({"caches", "--trace", "t.lackey", "--machines", "both.json"}, folder);
    ASSERT_EQ(ours.exit_code, 0) << ours.err;
    std::map<std::string, std::pair<double, double>> levels;
    for (const std::string& line : lines_of(ours.out)) {
        std::istringstream words(line);
        std::string machine, level;
        double accesses = 0, misses = 0;
        if (words >> machine >> level >> accesses >> misses && machine == "both")
            levels[level] = {accesses, misses};
    }
    ASSERT_EQ(levels.size(), 2U) << ours.out;
    EXPECT_GT(theirs.d1, 1000);
    EXPECT_NEAR(levels["D1"].first, theirs.accesses, 0.05 * theirs.accesses);
    EXPECT_NEAR(levels["D1"].second, theirs.d1, 0.01 * theirs.d1);
    std::printf("/bin/true: D1 misses %.0f, Cachegrind's %.0f of %.0f references\n", levels["D1"].second,
                theirs.d1, theirs.accesses);
}

}  // namespace
}  // namespace edgewise
