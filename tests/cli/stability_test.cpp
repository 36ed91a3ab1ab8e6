// SPDX-License-Identifier: MIT
//
// `edgewise stability`: rows in the store, a chapter in the report, and what is said when a name is wrong.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(Stability, WritesARowForEachFamilyAlgorithmAndTableType) {
    const Folder folder;
    const Outcome outcome = run({"stability", "--families", "parallel_faces,grazing", "--layouts", "aos",
                                 "--count", "10", "--store", "s.db", "--json"},
                                folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["rows"], 2 * 3 * 2);
    EXPECT_EQ(summary["verified"], summary["rows"]);
    const auto cases = rows_of(folder / "s.db", "select value from figure where name = 'cases'");
    EXPECT_THAT(cases, testing::SizeIs(12));
    EXPECT_THAT(cases, testing::Each(HasSubstr("10")));
    const Outcome report = run({"report", "s.db", "--out", "pages"}, folder);
    EXPECT_EQ(report.exit_code, 0) << report.err;
    EXPECT_THAT(text_of(folder / "pages/results/stability.csv"), HasSubstr("parallel_faces"));
    EXPECT_THAT(text_of(folder / "pages/index.html"), HasSubstr("data-chart=\"tolerance\""));
}

/// A time that is measured again is another one.
TEST(Stability, MeasuresWhatTheStoreLacks) {
    const Folder folder;
    const auto rows_after = [&](const Arguments& more) {
        const Arguments command = {"stability", "--families", "grazing", "--layouts", "aos_f64",
                                   "--count",   "5",          "--store", "s.db"};
        EXPECT_EQ(run(with(command, more), folder).exit_code, 0);
        return rows_of(folder / "s.db", "select value from figure where name like 'ns_at%' order by 1");
    };
    const auto first = rows_after({});
    EXPECT_FALSE(first.empty());
    EXPECT_EQ(rows_after({}), first);
    EXPECT_GT(rows_after({"--proofs", "0"}).size(), first.size()) << "rows of other proofs are others";
}

/// V-Clip takes no table without faces.
TEST(Stability, ThatComparedNothingIsNotPassed) {
    const Folder folder;
    const Outcome nobody = run({"stability", "--families", "grazing", "--layouts", "points_soa_f64",
                                "--algorithms", "vclip", "--count", "5", "--store", "s.db"},
                               folder);
    EXPECT_EQ(nobody.exit_code, 1);
    EXPECT_THAT(nobody.err, HasSubstr("nothing was compared"));
}

TEST(Stability, AnUnknownFamilyIsOneLineThatListsTheKnown) {
    const Folder folder;
    const Outcome outcome = run({"stability", "--families", "easy", "--store", "s.db"}, folder);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("unknown family 'easy'"));
    EXPECT_THAT(outcome.err, HasSubstr("bad_warm_start"));
}

}  // namespace
}  // namespace edgewise::cli_test
