// SPDX-License-Identifier: MIT
//
// Other libraries compared with ours: found, measured, checked and reported, each with right answers except
// for its own mistakes, which are counted on the corpus; and the messages where there are none.
#include <gmock/gmock.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli_paths.hpp"
#include "program.hpp"
#include "sweep_store.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

/// Number of modules in the program's folder.
std::size_t peers_built() {
    const auto folder = std::filesystem::path(program_path).parent_path() / "peers";
    if (!std::filesystem::exists(folder)) return 0;
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(Peers, AreMeasuredAndJudgedBesideOurs) {
    if (peers_built() == 0) GTEST_SKIP() << "built without EDGEWISE_PEERS";
    const Folder folder;
    const Outcome outcome =
        run({"sweep", "--plan", "peers", "--scenes", "cold", "--shapes", "cube8", "--layouts", "aos_f64",
             "--queries", "1000", "--checked", "200", "--rounds", "3", "--json"},
            folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json summary = json::parse(outcome.out);
    EXPECT_EQ(summary["verified"], 12)
        << "V-Clip and GJK, alone, in batches, for a verdict, within a margin, "
           "of rounded bodies, and GJK with two tolerances";
    EXPECT_EQ(summary["failed"], 0);
    const std::size_t all = 3 * peers_built() - 1;  // for a distance, for a verdict, of rounded bodies
    EXPECT_EQ(summary["judged"], all) << "libccd gives no distance, and so nothing of rounded bodies";
    EXPECT_THAT(text_of(folder / "reports/out/index.html"), HasSubstr("How far are the libraries?"));

    const auto judged_whose = [&](const std::string& figure, const std::string& condition) {
        return rows_of(folder / "reports/out/edgewise.db",
                       "select c.table_type from cell c join figure f using(build, hash) where c.status = "
                       "'judged' and f.value is not null and f.probe || '.' || f.name = '" +
                           figure + "' and f.value " + condition);
    };
    // On pairs this harmless they are right: shapes, poses and frames are what they should be.
    EXPECT_THAT(judged_whose("error.wrong_verdicts", "<> 0"), IsEmpty());
    EXPECT_THAT(judged_whose("error.p99_error_stored", "> 1e-6"), IsEmpty());
    EXPECT_EQ(judged_whose("error.p99_error_stored", ">= 0").size(), 2 * (peers_built() - 1));
    EXPECT_EQ(judged_whose("time.separated_ns", "> 0").size(), all);
    EXPECT_THAT(judged_whose("bytes.table_bytes", "not between 24 * 4 and 4096"), IsEmpty());
}

/// How often a library got each verdict of `judge`.
using Verdicts = std::map<std::string, int>;

/// Asks the libraries that Debian has about every pair of the corpus, each in a process of its own.
std::map<std::string, Verdicts> verdicts_on_the_corpus() {
    const auto corpus = std::filesystem::path(options_file).parent_path() / "../tests/corpus";
    const Folder folder;
    std::map<std::string, Verdicts> found;
    for (const char* file : {"own_failures.jsonl", "published_failures.jsonl"}) {
        for (const std::string& line : lines_of(text_of(corpus / file))) {
            folder.write("pair.json", line);
            const Outcome outcome =
                run({"judge", "pair.json", "--as-given", "--layouts", "aos_f64", "--algorithms", "vclip",
                     "--peers", "bullet_epa2,bullet_pair_detector,fcl_indep,fcl_libccd,libccd", "--json"},
                    folder);
            EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 1) << line << outcome.err;
            if (outcome.out.empty()) continue;
            const json judged = json::parse(outcome.out);
            for (const json& answer : judged["answers"]) ++found[answer["who"]][answer["verdict"]];
        }
    }
    return found;
}

/// Each row of the page: the library, then its wrong verdicts, wrong distances, and refusals.
TEST(Peers, AreWrongOnTheCorpusAsOftenAsThePageSays) {
    if (peers_built() == 0) GTEST_SKIP() << "built without EDGEWISE_PEERS";
    const std::string page =
        text_of(std::filesystem::path(options_file).parent_path() / "other_libraries.md");
    std::size_t peers = 0;
    for (auto& [who, verdicts] : verdicts_on_the_corpus()) {
        int answers = 0;
        for (const auto& [verdict, count] : verdicts) answers += count;
        EXPECT_EQ(answers, 210) << who;
        EXPECT_EQ(verdicts["no answer"], 0) << who;
        if (who.find(" on ") != who.npos) continue;  // ours, which the tests of the corpus check
        ++peers;
        std::ostringstream row;
        row << "| `" << who << "` | " << verdicts["wrong verdict"] << " | " << verdicts["wrong distance"]
            << " | " << verdicts["refused"] << " |\n";
        EXPECT_THAT(page, HasSubstr(row.str()))
            << "if this is another version of the library, write its counts";
    }
    EXPECT_EQ(peers, 7U);
}

TEST(Peers, OneThatIsNotThereIsSaid) {
    const Folder folder;
    const Outcome outcome = run({"sweep", "--peers", "nobody"}, folder);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr(peers_built() > 0 ? "unknown peer 'nobody'" : "no peers are built"));
}

}  // namespace
}  // namespace edgewise::cli_test
