// SPDX-License-Identifier: MIT
//
// `edgewise campaign`: figures, going on after a stop, shards, and one pair again.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli_paths.hpp"
#include "program.hpp"

namespace edgewise::cli_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Arguments small(const Arguments& more, const std::string& state = "s.json") {
    return with({"campaign", "--families", "random,grazing", "--shapes", "cube8", "--layouts", "aos_f64",
                 "--algorithms", "gjk", "--state", state, "--failures", "f.jsonl", "--every-type", "--json"},
                more);
}

/// Without what is timed.
json figures_of(json progress) {
    for (auto& family : progress["families"])
        for (const char* seconds : {"making_s", "asking_s", "proving_s"}) family.erase(seconds);
    for (const char* timed : {"seconds", "pairs_per_second", "answers_per_second", "classes", "shard"})
        progress.erase(timed);
    return progress;
}

TEST(CampaignCommand, ProvesAllPairsThatItWasAskedFor) {
    const Folder folder;
    const Outcome outcome = run(small({"--pairs", "1e4"}), folder);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const json line = json::parse(outcome.out);
    EXPECT_EQ(line["pairs"], 10'000);
    EXPECT_EQ(line["answers"], 100'000)
        << "cold and warm, by cofactors, by Johnson's search, for the verdict, within a margin, and rounded";
    EXPECT_EQ(line["wrong"], 0);
    EXPECT_EQ(line["done"], true);
    EXPECT_GT(line["share_by_filter"], 0.9);
    EXPECT_GT(line["families"]["random cube8"]["pairs"], 0);
    EXPECT_FALSE(std::filesystem::exists(folder / "f.jsonl"));
    const Outcome table = run({"campaign", "--families", "random", "--shapes", "cube8", "--layouts",
                               "aos_f64", "--algorithms", "gjk", "--pairs", "100", "--state", "t.json"},
                              folder);
    EXPECT_THAT(table.out, HasSubstr("random cube8"));
    EXPECT_THAT(table.out, HasSubstr("0 wrong"));
}

/// Bodies of more vertices than these layouts take.
TEST(CampaignCommand, ThatComparedNothingSaysSo) {
    const Folder folder;
    for (const char* layouts : {"physx", "box3d", "physx,box3d"}) {
        const Outcome outcome = run(
            words_of(std::string("campaign --families random --shapes sphere1538 --pairs 500 --layouts ") +
                     layouts + " --state " + layouts + ".json"),
            folder);
        EXPECT_EQ(outcome.exit_code, 1) << layouts;
        EXPECT_THAT(outcome.out, HasSubstr("0 answers"));
        EXPECT_THAT(outcome.out, HasSubstr("nothing was compared"));
        EXPECT_THAT(outcome.out, testing::Not(HasSubstr("0 wrong")));
    }
    const Outcome some = run({"campaign", "--families", "random", "--shapes", "sphere1538", "--pairs", "500",
                              "--layouts", "physx,aos_f32", "--state", "some.json"},
                             folder);
    EXPECT_EQ(some.exit_code, 0) << some.err;
    EXPECT_THAT(some.out, HasSubstr("0 wrong"));
}

TEST(CampaignCommand, TakesAMeshFileOfAnyName) {
    const Folder folder;
    const std::string no_utf_8 = "\xff.obj";
    folder.write(no_utf_8, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
    const Outcome outcome = run({"campaign", "--families", "random", "--shapes", no_utf_8, "--layouts",
                                 "aos_f64", "--pairs", "100", "--state", "s.json"},
                                folder);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("0 wrong"));
}

TEST(CampaignCommand, GoesOnAfterASignalWithTheSameFigures) {
    const Folder folder, other;
    const Arguments asked = small({"--pairs", "2e5"});
    Process stopped(program_path, asked, folder);
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    stopped.send(SIGTERM);
    static_cast<void>(stopped.wait());
    const Outcome rest = run(asked, folder), whole = run(asked, other);
    ASSERT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(figures_of(json::parse(rest.out)), figures_of(json::parse(whole.out)));
}

TEST(CampaignCommand, ShardsAddUp) {
    const Folder folder, other;
    for (const std::string i : {"0", "1"})
        ASSERT_EQ(run(small({"--pairs", "3e4", "--shard", i + "/2"}, "s" + i + ".json"), folder).exit_code,
                  0);
    const Outcome sum =
        run({"campaign", "--add", "s0.json", "s1.json", "--state", "all.json", "--json"}, folder);
    const Outcome whole = run(small({"--pairs", "3e4"}), other);
    EXPECT_EQ(sum.exit_code, 0) << sum.err;
    EXPECT_EQ(figures_of(json::parse(sum.out)), figures_of(json::parse(whole.out)));
    const Outcome half = run({"campaign", "--add", "s1.json", "--state", "half.json", "--json"}, folder);
    EXPECT_EQ(half.exit_code, 1);
    EXPECT_EQ(json::parse(half.out)["done"], false);
    const Outcome resumed = run(small({"--pairs", "3e4"}, "half.json"), folder);
    EXPECT_EQ(resumed.exit_code, 2);
    EXPECT_THAT(resumed.err, HasSubstr("half.json: a sum of parts that are not all there"));
    const Outcome onto = run({"campaign", "--add", "s0.json", "s1.json", "--state", "s0.json"}, folder);
    EXPECT_EQ(onto.exit_code, 2);
    EXPECT_THAT(onto.err, HasSubstr("s0.json: progress of another campaign"));
}

/// What another program, or another body of that name, gave is no part of this campaign.
TEST(CampaignCommand, GoesOnOnlyWithItsProgramAndBodies) {
    const Folder folder;
    const auto body = [&](const char* apex) {
        folder.write("t.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 ") + apex +
                                  "\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    };
    const Arguments ask = {"campaign", "--families", "random",  "--shape", "t.obj", "--pairs",
                           "100",      "--layouts",  "aos_f64", "--state", "c.json"};
    body("1");
    ASSERT_EQ(run(ask, folder).exit_code, 0);
    EXPECT_EQ(run(ask, folder).exit_code, 0) << "done";
    EXPECT_THAT(run(with(ask, {"--seed", "2"}), folder).err, HasSubstr("another seed"));
    body("2");
    const Outcome other = run(ask, folder);
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_THAT(other.err, HasSubstr("c.json: progress of a campaign of another program, or with another"));
}

TEST(CampaignCommand, GivesAPairAgainAsACase) {
    const Folder folder;
    const Outcome line = run({"campaign", "--families", "grazing", "--pair", "5000"}, folder);
    ASSERT_EQ(line.exit_code, 0) << line.err;
    folder.write("case.jsonl", line.out);
    const Outcome answer = run({"query", "case.jsonl", "--algorithm", "gjk", "--layout", "aos_f64"}, folder);
    EXPECT_EQ(answer.exit_code, 0) << answer.err;
    EXPECT_EQ(json::parse(answer.out)["id"], "pair 5000");
}

}  // namespace
}  // namespace edgewise::cli_test
