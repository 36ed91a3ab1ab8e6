// SPDX-License-Identifier: MIT
//
// A disk that is full, a file that is damaged, a store of an older program, readers while it is written: what
// was stored stays, and one line says what happened.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "../complaint.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/schema.hpp"
#include "edgewise/store/store.hpp"
#include "store_fixture.hpp"

namespace edgewise::store {
namespace {

using testing::AllOf;
using testing::HasSubstr;

CellRow cell_called(const std::string& hash) {
    CellRow cell;
    cell.hash = hash;
    cell.scene = "tumble";
    cell.status = CellStatus::verified;
    return cell;
}

void put_cell(Store& store, int number) {
    const FigureRow figures[] = {{{"total_bytes_per_edge", 168.0, "B/edge"}, "bytes"}};
    store.put_cell("build-1", cell_called("cell-" + std::to_string(1000 + number)), figures);
}

/// In a child, on a disk of 300 kB of its own: 0 when every finished cell is there after the disk was full,
/// and the line said what to do; 77 where no such disk can be had.
int fill_a_disk(const std::string& folder) {
    if (unshare(CLONE_NEWNS | (geteuid() == 0 ? 0 : CLONE_NEWUSER)) != 0) return 77;
    if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return 77;
    if (mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=300k") != 0) return 77;
    const std::string path = folder + "/s.db";
    int stored = 0;
    std::string said;
    try {
        Store store(path);
        store.put_build({"build-1", "abc", "g++", "-O3", "Release", "{}"});
        for (; stored < 100'000; ++stored) put_cell(store, stored);
    } catch (const std::runtime_error& problem) {
        said = problem.what();
    }
    std::printf("%d cells until: %s\n", stored, said.c_str());
    std::fflush(stdout);
    if (stored < 10 || said.find("free some space") == std::string::npos) return 1;
    if (read_build(path).cells.size() != static_cast<std::size_t>(stored)) return 2;
    // With room again, the same store goes on.
    if (mount("tmpfs", folder.c_str(), "tmpfs", MS_REMOUNT, "size=2m") != 0) return 3;
    Store store(path);
    put_cell(store, stored);
    return read_build(path).cells.size() == static_cast<std::size_t>(stored) + 1 ? 0 : 4;
}

TEST_F(StoreTest, AFullDiskLosesNothingThatWasFinished) {
    const pid_t child = fork();
    if (child == 0) _exit(fill_a_disk(directory_.string()));
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == 77) GTEST_SKIP() << "no disk of its own can be mounted here";
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

/// Files with bytes overwritten at many places: opening a file reads it or gives an error of one line, never
/// a crash. A file without its header is not changed.
TEST_F(StoreTest, ADamagedFileIsOneLine) {
    {
        Store store(path_);
        store.put_build({"build-1", "abc", "g++", "-O3", "Release", "{}"});
        for (int i = 0; i < 200; ++i) put_cell(store, i);
    }
    std::ifstream stream(path_, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    int refused = 0, read = 0;
    for (std::size_t trial = 0; trial < 120; ++trial) {
        std::string damaged = whole;
        const std::size_t at = trial * 2654435761U % damaged.size();
        if (trial % 3 == 0)
            damaged.resize(at);
        else
            damaged.replace(at, std::min<std::size_t>(64, damaged.size() - at), std::string(64, '\xa5'));
        std::ofstream(path_, std::ios::binary) << damaged;
        const std::string unread = complaint_of([&] { return read_build(path_); });
        ++(unread.empty() ? read : refused);
        EXPECT_TRUE(unread.empty() || unread.find(path_) != std::string::npos) << unread;
        EXPECT_EQ(unread.find('\n'), std::string::npos);
        const std::string unwritten = complaint_of([&] {
            Store store(path_);
            put_cell(store, 1);
            return 0;
        });
        EXPECT_TRUE(unwritten.empty() || unwritten.find(path_) != std::string::npos) << unwritten;
    }
    std::printf("damaged stores: %d refused, %d read\n", refused, read);
    EXPECT_GT(refused, 20);
}

TEST_F(StoreTest, AnOlderSchemaIsRefusedWithWhatHelps) {
    { const Store created(path_); }
    sqlite::Database(path_).execute("pragma user_version = 4");
    EXPECT_THAT(complaint_of([&] { const Store store(path_); }),
                AllOf(HasSubstr("schema version 4"), HasSubstr("name another store")));
    EXPECT_THAT(complaint_of([&] { return read_build(path_); }),
                AllOf(HasSubstr("schema version 4"), HasSubstr("write a new store with a sweep")));
}

/// Two writers and a reader at once: each cell once, whole, and the reader never sees half of one.
TEST_F(StoreTest, TwoWritersAndAReaderDoNotDisturbEachOther) {
    constexpr int cells = 60;
    {
        Store store(path_);
        store.put_build({"build-1", "abc", "g++", "-O3", "Release", "{}"});
        put_cell(store, 0);
    }
    const auto write = [&](int first) {
        Store store(path_);
        for (int i = first; i < first + cells; ++i) put_cell(store, i);
    };
    std::thread one(write, 1), two(write, 1 + cells / 2);  // of half of them both
    std::size_t seen = 0;
    for (int look = 0; look < 40; ++look) {
        const StoredBuild build = read_build(path_);
        EXPECT_GE(build.cells.size(), seen) << "none vanishes";
        seen = build.cells.size();
        for (const StoredCell& cell : build.cells) EXPECT_EQ(cell.figures.size(), 1U) << cell.hash;
    }
    one.join();
    two.join();
    EXPECT_EQ(read_build(path_).cells.size(), 1U + cells + cells / 2);
}

/// Writes rounds for ever, each acknowledged through the pipe once put_round has returned.
[[noreturn]] void write_rounds(const std::string& path, int first, int pipe_end) {
    Store store(path);
    for (int number = first;; ++number) {
        const std::vector<std::pair<std::string, measure::Round>> rounds = {{"cell-1", sample_round(number)},
                                                                            {"cell-2", sample_round(number)}};
        store.put_round("build-1", rounds);
        if (write(pipe_end, &number, sizeof number) != sizeof number) _exit(1);
    }
}

/// Kills a writer after about `enough` rounds; the last round that it acknowledged.
int kill_writer(const std::string& path, int first, int enough) {
    int ends[2];
    if (pipe(ends) != 0) return -1;
    const pid_t child = fork();
    if (child < 0) return -1;
    if (child == 0) {
        close(ends[0]);
        write_rounds(path, first, ends[1]);
    }
    close(ends[1]);
    int last = -1;
    int number = 0;
    while (read(ends[0], &number, sizeof number) == sizeof number) {
        last = number;
        if (last == first + enough)
            kill(child, SIGKILL);  // and read on: what it still acknowledged counts too
    }
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    return last;
}

TEST_F(StoreTest, KillLosesNoAcknowledgedRound) {
    int first = 0;
    int unacknowledged = 0;
    for (const int enough : {0, 1, 7, 40, 133, 250}) {
        const int last = kill_writer(path_, first, enough);
        ASSERT_GE(last, first + enough);
        const Store store(path_);
        const auto rounds = store.rounds("build-1", "cell-1");
        // No acknowledged round is missing. At most one more round is stored: the kill came before its
        // acknowledgement.
        ASSERT_GE(static_cast<int>(rounds.size()), last + 1);
        ASSERT_LE(static_cast<int>(rounds.size()), last + 2);
        unacknowledged += static_cast<int>(rounds.size()) - (last + 1);
        for (std::size_t i = 0; i < rounds.size(); ++i) {
            ASSERT_TRUE(equal(rounds[i], sample_round(static_cast<int>(i)))) << i;
        }
        // A round is whole or not there: both cells have the same ones.
        EXPECT_EQ(store.rounds_done("build-1", "cell-1"), store.rounds_done("build-1", "cell-2"));
        first = static_cast<int>(rounds.size());
    }
    std::printf("rounds kept: %d, including %d committed but not yet acknowledged at a kill\n", first,
                unacknowledged);
}

}  // namespace

}  // namespace edgewise::store
