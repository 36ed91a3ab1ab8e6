// SPDX-License-Identifier: MIT
//
// A limit on memory, where the system lets one be set; else the reason. And pages that leave memory and come
// back.
#include "edgewise/measure/process/memory_limit.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <filesystem>

#include "../temporary_folder.hpp"
#include "edgewise/bench/memory/arena.hpp"
#include "edgewise/measure/cache/reuse_distance.hpp"
#include "edgewise/measure/process/thread_usage.hpp"

namespace edgewise::measure {
namespace {

TEST(MemoryLimit, KnowsTheProcessesOwnGroupInBothVersions) {
    const std::string first = "12:cpu,cpuacct:/a\n4:memory:/process/b\n0::/c\n";
    EXPECT_EQ(control_group_in(first, "memory"), "/process/b");
    EXPECT_EQ(control_group_in(first, "cpuacct"), "/a");
    EXPECT_EQ(control_group_in(first, "cpu"), "/a");
    EXPECT_EQ(control_group_in(first, ""), "/c");
    EXPECT_EQ(control_group_in("0::/user.slice/x\n", ""), "/user.slice/x");
    EXPECT_EQ(control_group_in("0::/user.slice/x\n", "memory"), "");
    EXPECT_EQ(control_group_in("nonsense\n", "memory"), "");
}

/// A made-up version 2: the folder is made in the own group, or, where that hands memory not down, above.
TEST(MemoryLimit, TakesTheFirstGroupThatHandsMemoryDown) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const fs::path& root = folder.path();
    fs::create_directories(root / "sys/fs/cgroup/own");
    folder.write("sys/fs/cgroup/cgroup.controllers", "memory");
    folder.write("proc/self/cgroup", "0::/own\n");
    const auto limit = MemoryLimit::make(root);
    EXPECT_FALSE(limit.value);
    EXPECT_NE(limit.reason.find("not handed down"), std::string::npos) << limit.reason;
    EXPECT_TRUE(fs::is_empty(root / "sys/fs/cgroup/own")) << "what was tried is removed";
}

/// A process that was killed leaves its group; the next one that makes a group takes it away.
TEST(MemoryLimit, RemovesGroupsOfProcessesThatAreNoMore) {
    namespace fs = std::filesystem;
    const TemporaryFolder folder;
    const fs::path& root = folder.path();
    const fs::path own = root / "sys/fs/cgroup/own";
    const pid_t gone = fork();
    if (gone == 0) _exit(0);
    waitpid(gone, nullptr, 0);
    const std::string dead = "edgewise-" + std::to_string(gone),
                      alive = "edgewise-" + std::to_string(getppid());
    for (const std::string& name : {dead, alive, std::string("edgewise-x1"), std::string("other-1")})
        fs::create_directories(own / name);
    folder.write("sys/fs/cgroup/cgroup.controllers", "memory");
    folder.write("proc/self/cgroup", "0::/own\n");
    EXPECT_FALSE(MemoryLimit::make(root).value);
    EXPECT_FALSE(fs::exists(own / dead));
    for (const std::string& name : {alive, std::string("edgewise-x1"), std::string("other-1")})
        EXPECT_TRUE(fs::exists(own / name)) << name;
}

TEST(MemoryLimit, IsThereOrSaysWhyNot) {
    EXPECT_FALSE(MemoryLimit::make("/nowhere").value);
    EXPECT_FALSE(MemoryLimit::make("/nowhere").reason.empty());
    const auto limit = MemoryLimit::make();
    if (!limit.value) {
        EXPECT_FALSE(limit.reason.empty());
        GTEST_SKIP() << "no limit may be set here: " << limit.reason;
    }
    EXPECT_EQ((*limit.value)->set_bytes(std::uint64_t{64} << 20), "");
    EXPECT_EQ((*limit.value)->set_bytes(0), "") << "none";
    EXPECT_NE((*limit.value)->take_in(-5), "") << "no such process";
}

TEST(ArenaPages, OfAFileGoAndComeBack) {
    bench::Arena arena(bench::Backing::file);
    constexpr std::size_t page = 4096, pages = 100;
    auto* const memory = static_cast<std::byte*>(arena.allocate(pages * page, page));
    for (std::size_t i = 0; i < pages; ++i) std::memset(memory + i * page, static_cast<int>(i), page);
    EXPECT_EQ(arena.resident(), pages * page);
    ASSERT_TRUE(arena.evict());
    EXPECT_EQ(arena.resident(), 0U);
    const ThreadUsage before = thread_usage();
    for (std::size_t i = 0; i < pages; ++i) ASSERT_EQ(std::to_integer<std::size_t>(memory[i * page]), i);
    const ThreadUsage during = thread_usage() - before;
    EXPECT_EQ(during.major_faults, pages) << "each page is read from the disk, and none ahead";
    EXPECT_EQ(arena.resident(), pages * page);
}

TEST(ArenaPages, OfMemoryCannotGo) {
    bench::Arena arena;
    auto* const memory = static_cast<std::byte*>(arena.allocate(4096, 64));
    std::memset(memory, 1, 4096);
    EXPECT_FALSE(arena.evict());
    EXPECT_EQ(std::to_integer<int>(memory[17]), 1);
}

TEST(PageReuse, SeesTablesOnlyAndPagesOnly) {
    PageReuse reuse(4096);
    const auto read = [&](std::uint64_t address, TraceSide side) {
        reuse.on_access({address, 8, AccessKind::read, 0, 0, side});
    };
    for (int pass = 0; pass < 2; ++pass) {
        if (pass == 1) reuse.start_counting();
        for (std::uint64_t i = 0; i < 10; ++i) {
            read(i * 4096 + 4092, TraceSide::table_a);  // two pages each
            read(1 << 30, TraceSide::scene);
            reuse.on_query_end(true);
        }
    }
    EXPECT_EQ(reuse.pages(), 11U);
    EXPECT_DOUBLE_EQ(reuse.fetches_per_query(11).all.value(), 0);
    EXPECT_DOUBLE_EQ(reuse.fetches_per_query(10).all.value(), 1.1)
        << "eleven pages in turn through room for ten";
}

}  // namespace
}  // namespace edgewise::measure
