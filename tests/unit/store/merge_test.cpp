// SPDX-License-Identifier: MIT
//
// Stores merged: the parts of a campaign come out as one, once, whoever is named first; what does not belong
// together is refused with both files named; an end at any moment leaves what was there.
#include "edgewise/store/merge.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "../complaint.hpp"
#include "edgewise/store/rows.hpp"
#include "edgewise/store/schema.hpp"
#include "store_fixture.hpp"

namespace edgewise::store {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

/// Contents of one synthetic store.
struct Made {
    std::string shard = {}, seed = "1", plan = "quick", revision = "abc", build = "build-1";
    bool complete = true;
    int rounds = 3;
    double bytes = 168;
    std::vector<std::string> cells = {};
};

class Merging : public StoreTest {
  protected:
    std::string make(const std::string& name, const Made& made) const {
        const std::string path = (directory_ / name).string();
        Store store(path);
        store.put_build({made.build, made.revision, "g++", "-O3", "Release", "{}"});
        store.set_meta("plan", made.plan);
        store.set_meta("seed", made.seed);
        if (!made.shard.empty()) store.set_meta(shard_key, made.shard);
        if (!made.shard.empty() && made.complete) store.set_meta(complete_key, made.shard);
        for (const std::string& hash : made.cells) {
            CellRow cell;
            cell.hash = hash;
            cell.scene = "tumble";
            cell.status = CellStatus::verified;
            const FigureRow figures[] = {{{"total_bytes_per_edge", made.bytes, "B/edge"}, "bytes"},
                                         {{"all_ns", 100.0 + made.rounds, "ns"}, "time"},
                                         {{"rounds", 1.0 * made.rounds, "rounds"}, "time"}};
            store.put_cell(made.build, cell, figures);
            for (int round = 0; round < made.rounds; ++round) {
                const std::pair<std::string, measure::Round> one[] = {{hash, sample_round(round)}};
                store.put_round(made.build, one);
            }
        }
        return path;
    }
    [[nodiscard]] std::string out() const { return (directory_ / "all.db").string(); }

    [[nodiscard]] std::string complaint(const std::vector<std::string>& stores, bool mixed = false) const {
        return complaint_of([&] { return merge_stores(stores, out(), mixed); });
    }
    [[nodiscard]] std::vector<std::string> hashes() const {
        std::vector<std::string> all;
        for (const StoredCell& cell : read_build(out()).cells) all.push_back(cell.hash);
        return all;
    }
};

TEST_F(Merging, DifferentSceneFilesOfOneNameAreRefused) {
    const std::string a = make("a.db", {.cells = {"c1"}}), b = make("b.db", {.cells = {"c2"}});
    Store(a).set_meta(std::string(scene_file_key) + "s", R"({"scene":"tumble"})");
    Store(b).set_meta(std::string(scene_file_key) + "s", R"({"scene":"cold"})");
    for (const bool mixed : {false, true})
        EXPECT_THAT(complaint({a, b}, mixed), AllOf(HasSubstr(a), HasSubstr(b), HasSubstr("'s'")));
    Store(b).set_meta(std::string(scene_file_key) + "s", R"({"scene":"tumble"})");
    EXPECT_EQ(complaint({a, b}), "");
}

TEST_F(Merging, PartsComeOutAsOneInAnyOrderAndAgain) {
    const std::string a = make("a.db", {.shard = "0/2", .cells = {"c1", "c3"}});
    const std::string b = make("b.db", {.shard = "1/2", .cells = {"c2"}});
    for (const auto& stores :
         {std::vector{a, b}, std::vector{b, a}, std::vector{a, b, a}, std::vector{out(), b, a}}) {
        const MergeSummary summary = merge_stores(stores, out(), false);
        EXPECT_EQ(summary.cells, 3U);
        EXPECT_THAT(summary.missing, ElementsAre());
        ASSERT_EQ(summary.builds.size(), 1U);
        EXPECT_EQ(summary.builds[0].cells, 3U);
        EXPECT_THAT(hashes(), ElementsAre("c1", "c2", "c3"));
        const StoredBuild read = read_build(out());
        EXPECT_EQ(read.cells[1].figures.size(), 3U);
        ASSERT_EQ(read.cells[1].rounds.size(), 3U);
        EXPECT_TRUE(equal(read.cells[1].rounds[2], sample_round(2)));
        EXPECT_EQ(find_meta(out(), "plan"), "quick");
        EXPECT_FALSE(find_meta(out(), shard_key)) << "it is no part";
        EXPECT_FALSE(std::filesystem::exists(out() + "-wal")) << "one file";
    }
}

TEST_F(Merging, SaysWhatIsMissing) {
    const std::string a = make("a.db", {.shard = "0/4", .cells = {"c1"}});
    const std::string b = make("b.db", {.shard = "2/4", .complete = false, .cells = {"c2"}});
    EXPECT_THAT(merge_stores({a, b}, out(), false).missing,
                ElementsAre("shard 1/4 is missing: no store is of it",
                            "shard 2/4 was stopped before its end: run it again, it goes on there",
                            "shard 3/4 is missing: no store is of it"));
    EXPECT_THAT(hashes(), ElementsAre("c1", "c2")) << "what is there is merged";
}

TEST_F(Merging, KnowsThePartsOfAMergedStore) {
    const std::string a = make("a.db", {.shard = "0/2", .cells = {"c1"}});
    const std::string b = make("b.db", {.shard = "1/2", .cells = {"c2"}});
    EXPECT_THAT(merge_stores({a}, out(), false).missing, testing::SizeIs(1));
    EXPECT_THAT(merge_stores({out(), b}, out(), false).missing, testing::IsEmpty());
    EXPECT_THAT(merge_stores({out()}, out(), false).missing, testing::IsEmpty());
}

TEST_F(Merging, KeepsMachinesAsTheyAre) {
    const std::string a = make("a.db", {.cells = {"c1", "c2"}});
    const std::string b = make("b.db", {.build = "build-2", .bytes = 90, .cells = {"c1"}});
    const MergeSummary summary = merge_stores({a, b}, out(), false);
    ASSERT_EQ(summary.builds.size(), 2U);
    EXPECT_EQ(summary.builds[0].id, "build-1") << "the one with the most cells";
    EXPECT_EQ(summary.twice, 0U) << "the same cell on two machines is two";
    EXPECT_EQ(read_build(out()).build.id, "build-1");
    EXPECT_EQ(read_build(out(), "build-2").cells[0].figure("bytes", "total_bytes_per_edge").value, 90);
}

TEST_F(Merging, ACellThatIsThereTwiceIsKeptWithItsRounds) {
    const std::string a = make("a.db", {.rounds = 2, .cells = {"c1"}});
    const std::string b = make("b.db", {.rounds = 5, .cells = {"c1", "c2"}});
    for (const auto& stores : {std::vector{a, b}, std::vector{b, a}}) {
        EXPECT_EQ(merge_stores(stores, out(), false).twice, 1U);
        const StoredBuild read = read_build(out());
        EXPECT_EQ(read.cells[0].rounds.size(), 5U);
        EXPECT_EQ(read.cells[0].figure("time", "all_ns").value, 105)
            << "figures are of the rounds that are kept";
    }
}

TEST_F(Merging, RefusesWhatDoesNotBelongTogether) {
    const std::string a = make("a.db", {.shard = "0/2", .cells = {"c1"}});
    const std::string seed = make("seed.db", {.seed = "2", .cells = {"c2"}});
    const std::string plan = make("plan.db", {.plan = "paper", .cells = {"c2"}});
    const std::string revision =
        make("revision.db", {.revision = "def", .build = "build-2", .cells = {"c2"}});
    const std::string shards = make("shards.db", {.shard = "1/3", .cells = {"c2"}});
    const std::string other = make("other.db", {.bytes = 84, .cells = {"c1"}});
    EXPECT_THAT(complaint({a, seed}), AllOf(HasSubstr("several seeds"), HasSubstr("a.db"),
                                            HasSubstr("seed.db"), HasSubstr("--mixed")));
    EXPECT_THAT(complaint({a, plan}), AllOf(HasSubstr("several plans"), HasSubstr("'paper'")));
    EXPECT_THAT(complaint({a, revision}), AllOf(HasSubstr("several revisions"), HasSubstr("def")));
    EXPECT_THAT(complaint({a, shards}), HasSubstr("several numbers of shards"));
    EXPECT_FALSE(std::filesystem::exists(out()));
    for (const std::string& path : {seed, plan, revision}) EXPECT_EQ(complaint({a, path}, true), "") << path;
    std::filesystem::remove(out());
    EXPECT_THAT(complaint({a, other}, true),
                AllOf(HasSubstr("disagree"), HasSubstr("bytes.total_bytes_per_edge"), HasSubstr("other.db")));
    EXPECT_FALSE(std::filesystem::exists(out()));
    for (const auto& entry : std::filesystem::directory_iterator(directory_))
        EXPECT_EQ(entry.path().string().find("merging"), std::string::npos) << "nothing is left behind";
}

TEST_F(Merging, WritesOverNothingThatIsNotItsOwn) {
    const std::string a = make("a.db", {.cells = {"c1"}}), b = make("all.db", {.cells = {"c9"}});
    EXPECT_THAT(complaint({a}), HasSubstr("is no merged store"));
    EXPECT_THAT(hashes(), ElementsAre("c9"));
    EXPECT_THAT(complaint({(directory_ / "none.db").string()}), HasSubstr("is no merged store"));
    std::filesystem::remove(b);
    EXPECT_THAT(complaint({(directory_ / "none.db").string()}), HasSubstr("no results store at"));
    std::ofstream(out()) << "a letter";
    EXPECT_NE(complaint({a}), "");
}

/// kill -9 at a random moment of a merge, many times: what had the name before has it still, whole, or the
/// merged store does.
TEST_F(Merging, SurvivesKills) {
    std::vector<std::string> cells;
    for (int i = 0; i < 60; ++i) cells.push_back("c" + std::to_string(100 + i));
    const std::string a = make("a.db", {.cells = {"c1"}}), b = make("b.db", {.cells = cells});
    static_cast<void>(merge_stores({a}, out(), false));
    int killed = 0, done = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const pid_t child = fork();
        if (child == 0) {
            static_cast<void>(merge_stores({a, b}, out(), false));
            _exit(0);
        }
        usleep(static_cast<useconds_t>(trial * trial * 40));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        ++(WIFSIGNALED(status) ? killed : done);
        const std::size_t count = hashes().size();
        EXPECT_TRUE(count == 1 || count == 61) << count;
    }
    std::printf("merges: %d killed, %d done before\n", killed, done);
    EXPECT_GT(killed, 0);
    EXPECT_EQ(merge_stores({a, b}, out(), false).cells, 61U);
    for (const auto& entry : std::filesystem::directory_iterator(directory_))
        EXPECT_EQ(entry.path().string().find("merging"), std::string::npos) << "what kills left is removed";
}

}  // namespace
}  // namespace edgewise::store
