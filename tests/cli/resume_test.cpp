// SPDX-License-Identifier: MIT
//
// A sweep that was ended half-way: what it stored stays, to the last digit, and the same command completes
// the rest.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli_paths.hpp"
#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;

constexpr std::size_t rounds_of_a_cell = 120, cells = 2 * 2 * 2;

/// Figures stay that a later sweep does not measure, and those of probes that an earlier one left out are
/// added.
TEST(SweepAgain, KeepsAndAddsFiguresOfProbes) {
    const Folder folder;
    const Arguments some = words_of(
        "sweep --scenes cold --shapes cube8 --layouts aos_f64 --algorithms gjk --queries 50 --checked 10 "
        "--store s.db --no-report");
    const auto count = [&](const std::string& probe) {
        return rows_of(folder / "s.db",
                       "select name from figure where value is not null and probe = '" + probe + "'")
            .size();
    };
    ASSERT_EQ(run(with(some, {"--rounds", "2", "--probes", "time", "error"}), folder).exit_code, 0);
    EXPECT_EQ(count("bytes"), 0U);
    ASSERT_EQ(run(with(some, {"--rounds", "2"}), folder).exit_code, 0);
    const std::size_t bytes = count("bytes");
    EXPECT_GT(bytes, 0U);
    ASSERT_EQ(run(with(some, {"--rounds", "3", "--probes", "time", "error"}), folder).exit_code, 0);
    EXPECT_EQ(count("bytes"), bytes);
    EXPECT_EQ(rounds_in(folder / "s.db").size(), 3U);
}

/// Several groups, so that the end comes with some cells complete, one group half-way and others not begun.
const Arguments sweep = words_of(
    "sweep --scenes cold,static --shapes sphere38,sphere102 --layouts aos_f64 "
    "--queries 100 --checked 20 --store s.db --json --rounds " +
    std::to_string(rounds_of_a_cell));

class Resume : public testing::Test {
  protected:
    /// Started, and ended by the signal when some rounds of the first two groups are stored.
    Outcome interrupted_by(int signal) {
        Process process(program_path, sweep, folder_);
        while (rounds_in(folder_ / "s.db").size() < 2 * rounds_of_a_cell + 4 && !process.has_ended()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        process.send(signal);
        return process.wait();
    }

    void expect_rest_is_completed(const std::vector<std::string>& kept) {
        ASSERT_GE(kept.size(), 2 * rounds_of_a_cell);
        ASSERT_LT(kept.size(), cells * rounds_of_a_cell) << "the sweep was over before it could be ended";
        const Outcome outcome = run(sweep, folder_);
        ASSERT_EQ(outcome.exit_code, 0) << "signal " << outcome.signal << ", " << outcome.err;
        const json summary = json::parse(outcome.out);
        EXPECT_EQ(summary["cells"], cells);
        EXPECT_EQ(summary["verified"], cells);
        const auto now = rounds_in(folder_ / "s.db");
        EXPECT_EQ(now.size(), cells * rounds_of_a_cell);
        EXPECT_THAT(now, IsSupersetOf(kept));
        const auto complete = rows_of(
            folder_ / "s.db", "select count(*) from round group by hash having count(distinct number) = " +
                                  std::to_string(rounds_of_a_cell));
        EXPECT_EQ(complete.size(), cells);
        EXPECT_TRUE(std::filesystem::exists(folder_ / "index.html"));
    }

    Folder folder_;
};

TEST_F(Resume, AfterAKill) {
    const Outcome outcome = interrupted_by(SIGKILL);
    EXPECT_EQ(outcome.signal, SIGKILL);
    expect_rest_is_completed(rounds_in(folder_ / "s.db"));
}

TEST_F(Resume, AfterCtrlC) {
    const Outcome outcome = interrupted_by(SIGINT);
    EXPECT_EQ(outcome.signal, 0);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("stopped"));
    const bool any_cells = outcome.err.find("before the first cells") == outcome.err.npos;
    EXPECT_EQ(std::filesystem::exists(folder_ / "index.html"), any_cells) << "a report of what is there";
    expect_rest_is_completed(rounds_in(folder_ / "s.db"));
}

/// The checked queries of every cell.
std::vector<std::string> checked_in(const Folder& folder) {
    return rows_of(folder / "s.db",
                   "select value from figure where probe = 'error' and name = 'checked' order by hash");
}

/// A cell with answers checked at 20 queries is not verified at 60; at 20 it is, once it is at 60.
TEST_F(Resume, AfterFewerChecksThanAreAskedFor) {
    Arguments arguments = {"sweep",   "--scenes",    "cold",   "--shapes",  "cube8", "--layouts",
                           "aos_f64", "--queries",   "100",    "--rounds",  "2",     "--store",
                           "s.db",    "--no-report", "--json", "--checked", "20"};
    ASSERT_EQ(run(arguments, folder_).exit_code, 0);
    const auto rounds = rounds_in(folder_ / "s.db");
    EXPECT_THAT(checked_in(folder_), ElementsAre("20.0", "20.0"));
    for (const char* checked : {"60", "20"}) {
        arguments.back() = checked;
        const Outcome outcome = run(arguments, folder_);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(json::parse(outcome.out)["verified"], 2);
        EXPECT_THAT(checked_in(folder_), ElementsAre("60.0", "60.0")) << "after " << checked;
        EXPECT_EQ(rounds_in(folder_ / "s.db"), rounds) << "times stay";
    }
}

}  // namespace
}  // namespace edgewise::cli_test
