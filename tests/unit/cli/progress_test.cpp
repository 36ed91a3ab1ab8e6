// SPDX-License-Identifier: MIT
//
// The progress line: fits every width, counts, and estimates from this run's own work alone.
#include "edgewise/cli/terminal/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace edgewise {
namespace {

TEST(Progress, FitsEveryWidthAndLosesTheNoteFirst) {
    const ProgressState state{31, 72, 0, 60};
    std::size_t longest = 0;
    for (std::size_t columns = 0; columns <= 200; ++columns) {
        const std::string line = progress_line("sweep", state, "tumble sphere386 vclip aos_f64", columns);
        EXPECT_LE(line.size(), columns);
        EXPECT_GE(line.size(), longest > 0 ? std::size_t{1} : std::size_t{0});
        longest = std::max(longest, line.size());
        if (columns >= 40) {
            EXPECT_NE(line.find("31/72"), std::string::npos) << columns;
        }
    }
    EXPECT_NE(progress_line("sweep", state, "note", 200).find("note"), std::string::npos);
    EXPECT_EQ(progress_line("sweep", state, "note", 40).find("note"), std::string::npos);
}

TEST(Progress, BarFillsWithTheWork) {
    const auto filled = [](std::size_t done) {
        const std::string line = progress_line("x", {done, 48, 0, 1}, "", 100);
        return std::count(line.begin(), line.end(), '#');
    };
    EXPECT_EQ(filled(0), 0);
    EXPECT_EQ(filled(24), 12);
    EXPECT_EQ(filled(47), 23);  // full only when all is done
    EXPECT_EQ(filled(48), 24);
    EXPECT_NE(progress_line("x", {48, 48, 0, 1}, "", 100).find("100 %"), std::string::npos);
    EXPECT_NE(progress_line("x", {0, 0, 0, 1}, "", 100).find("100 %"), std::string::npos);
    EXPECT_NE(progress_line("x", {199, 200, 0, 1}, "", 100).find(" 99 %"), std::string::npos);
}

TEST(Progress, EstimateLeavesResumedWorkOut) {
    EXPECT_NE(progress_line("x", {10, 40, 0, 20}, "", 100).find("1m00s left"), std::string::npos);
    EXPECT_NE(progress_line("x", {30, 40, 20, 20}, "", 100).find(" 20s left"), std::string::npos);
    EXPECT_EQ(progress_line("x", {20, 40, 20, 5}, "", 100).find("left"), std::string::npos);  // no idea yet
    EXPECT_EQ(progress_line("x", {40, 40, 0, 5}, "", 100).find("left"), std::string::npos);
}

/// If cells take from 1 s to 60 s, their number does not give the time left.
TEST(Progress, OfStepsThatDifferSaysWhatItIsToldOrNothing) {
    ProgressState state{90, 100, 0, 100};
    state.even = false;
    EXPECT_EQ(progress_line("x", state, "", 100).find("left"), std::string::npos);
    state.left = 300;
    EXPECT_NE(progress_line("x", state, "", 100).find(" 90 %  90/100  5m00s left"), std::string::npos);
    state.done = 100;
    EXPECT_EQ(progress_line("x", state, "", 100).find("left"), std::string::npos);
}

TEST(Progress, WritesLinesForALog) {
    ProgressState state{434, 1281, 0, 90};
    EXPECT_EQ(progress_log_line("sweep", state, "cells"), "sweep: 434 of 1281 cells, 3 min left");
    state.even = false;
    EXPECT_EQ(progress_log_line("sweep", state, "cells"), "sweep: 434 of 1281 cells");
    state.left = 10;
    EXPECT_EQ(progress_log_line("sweep", state, "cells"), "sweep: 434 of 1281 cells, 10 s left");
    EXPECT_EQ(progress_log_line("sweep", {0, 9, 0, 90}, "rows"), "sweep: 0 of 9 rows");
}

TEST(Progress, NamesCannotBreakTheLine) {
    const std::string line = progress_line("a\nb", {1, 2, 0, 1}, "m\xc3\xa4sh\x1b[2J\r", 100);
    for (const char c : line) EXPECT_TRUE(c >= ' ' && c <= '~');
}

TEST(Progress, Durations) {
    EXPECT_EQ(format_duration(0), "0s");
    EXPECT_EQ(format_duration(59.4), "59s");
    EXPECT_EQ(format_duration(59.6), "1m00s");
    EXPECT_EQ(format_duration(185), "3m05s");
    EXPECT_EQ(format_duration(2 * 3600 + 7 * 60 + 59), "2h07m");
    EXPECT_EQ(format_duration(-5), "0s");
    EXPECT_EQ(format_duration(std::nan("")), "0s");
    EXPECT_EQ(format_duration(1e300), "720h00m");
}

TEST(Progress, IsSilentWhereStderrIsNoTerminal) {
    testing::internal::CaptureStderr();  // into a file; the first line of a log is due after half a minute
    {
        Progress progress("x", 3);
        progress.advance(1, "one");
        progress.advance(5);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace edgewise
