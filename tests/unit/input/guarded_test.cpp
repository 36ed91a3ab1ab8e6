// SPDX-License-Identifier: MIT
//
// Work in a child under limits: its answer comes back whole; what it does instead of answering is one line.
#include "edgewise/input/guarded.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <new>

namespace edgewise::input {
namespace {

using testing::HasSubstr;
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
