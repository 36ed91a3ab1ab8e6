// SPDX-License-Identifier: MIT
//
// `edgewise paging` ended by a signal: the control group that limited its memory is gone with it.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Returns true if a control group of that name exists anywhere.
bool has_group(const std::string& name) {
    std::error_code error;
    for (fs::recursive_directory_iterator at("/sys/fs/cgroup", error), end; !error && at != end;
         at.increment(error)) {
        if (at->path().filename() == name) return true;
    }
    return false;
}

class Paging : public testing::TestWithParam<int> {};

TEST_P(Paging, LeavesNoControlGroup) {
    const Folder folder;
    Process process(program_path, {"paging", "--bodies", "200", "--steps", "4", "--layouts", "aos_f64"},
                    folder);
    const std::string group = "edgewise-" + std::to_string(process.id());
    bool seen = false;
    while (!seen && !process.has_ended()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        seen = has_group(group);
    }
    process.send(GetParam());
    const Outcome outcome = process.wait();
    if (!seen) {
        EXPECT_THAT(outcome.out, HasSubstr("no memory limit")) << "nothing was limited";
        GTEST_SKIP() << "no control group can be made here";
    }
    EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("stopped"));
    EXPECT_FALSE(has_group(group));
}

INSTANTIATE_TEST_SUITE_P(EndedBy, Paging, testing::Values(SIGTERM, SIGINT),
                         [](const auto& signal) { return signal.param == SIGTERM ? "Sigterm" : "CtrlC"; });

}  // namespace
}  // namespace edgewise::cli_test
