// SPDX-License-Identifier: MIT
//
// A probe and a study of the tests' own (fixture/edgewise), each a file and a line of a manifest: the program
// lists, runs, shards, stores and reports them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli_paths.hpp"
#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// A sweep of one cell on the layout `straight`, with the study's first three numbers.
class Additions : public testing::Test {
  protected:
    Additions() {
        folder_.write("plan.json", R"({"shapes": ["cube8"], "meshes": [], "scenes": [{"name": "cold"}],
            "layouts": ["straight"], "queries": 100, "checked": 10, "rounds": 2, "stability": 0,
            "scratch": 3})");
    }
    [[nodiscard]] Outcome sweep(const Arguments& more) const {
        return Process(crooked_program_path, with({"sweep", "--plan", "plan.json", "--json"}, more), folder_)
            .wait();
    }
    [[nodiscard]] std::vector<std::string> numbers_in(const std::string& store) const {
        return rows_of(folder_ / store, "select shape from cell where run = 'scratch' order by shape");
    }

    Folder folder_;
};

TEST_F(Additions, AStudyIsMeasuredStoredAndReported) {
    const Outcome outcome = sweep({"--store", "s.db"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["cells"], 1) << "rows of a study are no cells of the sweep";
    EXPECT_EQ(summary["scratch_rows"], 3);
    EXPECT_EQ(summary["scratch_failed"], 0);
    EXPECT_THAT(rows_of(folder_ / "s.db",
                        "select shape, name, value from cell join figure using(build, hash) where run = "
                        "'scratch' order by shape"),
                ElementsAre("1|square|1.0", "2|square|4.0", "3|square|9.0"));
    for (const char* page : {"report.md", "index.html"}) {
        const std::string text = text_of(folder_ / page);
        for (const char* said :
             {"What are the squares?", "Each number times itself.", "half of the square", "4.5"})
            EXPECT_THAT(text, HasSubstr(said)) << page;
    }
}

/// Progress expects the rows, and the next sweep expects the seconds that they took here.
TEST_F(Additions, AStudyIsResumedAndItsTimeIsKept) {
    ASSERT_EQ(sweep({"--store", "s.db", "--no-report"}).exit_code, 0);
    EXPECT_EQ(rows_of(folder_ / "s.db", "select count(*) from meta where key = 'took part scratch 3'"),
              std::vector<std::string>{"1"});
    const Outcome again = sweep({"--store", "s.db", "--no-report"});
    ASSERT_EQ(again.exit_code, 0) << again.err;
    EXPECT_FALSE(json::parse(again.out).contains("scratch_rows")) << "all of them are there";
}

TEST_F(Additions, ShardsHaveEachPartOfAStudyOnce) {
    std::vector<std::string> all;
    for (const char* shard : {"0", "1", "2"}) {
        const std::string store = std::string(shard) + ".db";
        ASSERT_EQ(sweep({"--store", store, "--shard", std::string(shard) + "/3"}).exit_code, 0);
        const auto mine = numbers_in(store);
        EXPECT_LE(mine.size(), 2U) << "odd and even numbers are parts of their own";
        all.insert(all.end(), mine.begin(), mine.end());
    }
    EXPECT_THAT(all, testing::UnorderedElementsAre("1", "2", "3"));
}

TEST_F(Additions, APlanKnowsTheStudyAndItsRange) {
    for (const auto& [plan, said] : {std::pair(R"({"scrach": 3})", "did you mean 'scratch'"),
                                     std::pair(R"({"scratch": 10})", "scratch = ")}) {
        folder_.write("plan.json", plan);
        const Outcome outcome = sweep({"--store", "s.db"});
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_THAT(outcome.err, HasSubstr(said));
    }
}

TEST_F(Additions, AProbeIsListedAndMeasured) {
    EXPECT_THAT(Process(crooked_program_path, {"list", "probes"}, folder_).wait().out,
                HasSubstr("queries of the cell"));
    ASSERT_EQ(sweep({"--store", "s.db", "--no-report"}).exit_code, 0);
    EXPECT_THAT(rows_of(folder_ / "s.db",
                        "select name, value from figure where probe = 'scratch' and "
                        "hash in (select hash from cell where run = 'sweep')"),
                ElementsAre("queries|100.0"));
}

}  // namespace
}  // namespace edgewise::cli_test
