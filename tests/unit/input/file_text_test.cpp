// SPDX-License-Identifier: MIT
//
// Files that users name: regular ones are read whole, all others are refused at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <new>

#include "../temporary_folder.hpp"
#include "edgewise/input/file_text.hpp"
#include "edgewise/input/guarded.hpp"

namespace edgewise::input {
namespace {

using testing::HasSubstr;

class FileText : public testing::Test {
  protected:
    [[nodiscard]] std::string path(const char* name) const { return folder_ / name; }

    const TemporaryFolder folder_;
};

TEST_F(FileText, IsReadWhole) {
    const std::string text("a\0b\r\n\xff", 6);
    std::ofstream(path("t"), std::ios::binary) << text;
    EXPECT_EQ(*read_file_text(path("t")), text);
    EXPECT_EQ(*read_file_text(path("t"), 6), text);
    EXPECT_THAT(read_file_text(path("t"), 5).error, HasSubstr("has 6 bytes, more than the 5"));
    std::filesystem::create_symlink("t", path("link"));
    EXPECT_EQ(*read_file_text(path("link")), text);
    std::ofstream(path("empty"));
    EXPECT_EQ(*read_file_text(path("empty")), "");
}

/// Special files are not opened: a pipe without a writer would block, and a device would never end.
TEST_F(FileText, RefusesWhatIsNoRegularFile) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    for (const std::string& file : {path("pipe"), std::string("/dev/zero"), std::string("/dev/null")})
        EXPECT_EQ(read_file_text(file).error,
                  file + ": is no regular file but a pipe, a device or the like: write it to a file first");
    EXPECT_THAT(read_file_text(path(".")).error, HasSubstr("is a directory"));
    EXPECT_EQ(read_file_text(path("none")).error, path("none") + ": no such file");
    std::filesystem::create_symlink("nowhere", path("dangling"));
    EXPECT_THAT(read_file_text(path("dangling")).error, HasSubstr("no such file"));
    std::filesystem::create_symlink("circle", path("circle"));
    EXPECT_THAT(read_file_text(path("circle")).error, HasSubstr("cannot be looked at"));
}

using namespace std::chrono_literals;

constexpr GuardLimits plenty{std::uint64_t{1} << 30, 60s};

TEST(Guarded, GivesWhatTheWorkReturns) {
    std::string long_text(3'000'000, '\0');  // longer than a pipe holds
    for (std::size_t i = 0; i < long_text.size(); ++i) long_text[i] = static_cast<char>(i % 251);
    for (const std::string& text : {std::string(), std::string("a\0b", 3), long_text}) {
        const auto answer = run_guarded([&] { return text; }, plenty);
        ASSERT_TRUE(answer) << answer.error;
        EXPECT_TRUE(*answer == text);
    }
}

TEST(Guarded, EndsWorkWithoutEnd) {
    const auto answer = run_guarded(
        []() -> std::string {
            for (;;) pause();
        },
        {std::uint64_t{1} << 30, 200ms});
    EXPECT_EQ(answer.error, "took longer than the 0.2 s it was given");
}

/// Memory from the kernel: a sanitizer's allocator ends the child itself, where others throw.
TEST(Guarded, EndsWorkThatTakesMemory) {
    const auto answer = run_guarded(
        []() -> std::string {
            for (;;) {
                if (mmap(nullptr, std::size_t{1} << 24, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) ==
                    MAP_FAILED)
                    throw std::bad_alloc();
            }
        },
        {std::uint64_t{1} << 28, 60s});
    EXPECT_THAT(answer.error, HasSubstr("took more than the 256 MiB of memory"));
}

TEST(Guarded, SurvivesACrash) {
    const auto answer = run_guarded(
        []() -> std::string {
            std::signal(SIGSEGV, SIG_DFL);
            raise(SIGSEGV);
            return "not reached";
        },
        plenty);
    EXPECT_EQ(answer.error, "crashed (signal 11)");
}

/// A signal that ends long work at the next round, here, ends the child at once.
TEST(Guarded, DoesNotKeepTheParentsHandlers) {
    const auto before = std::signal(SIGTERM, SIG_IGN);
    const auto answer = run_guarded(
        []() -> std::string {
            raise(SIGTERM);
            return "not reached";
        },
        plenty);
    std::signal(SIGTERM, before);
    EXPECT_EQ(answer.error, "crashed (signal 15)");
}

}  // namespace

}  // namespace edgewise::input
