// SPDX-License-Identifier: MIT
//
// `edgewise judge` on pairs as they were posted (dumps/): the exact distance, and which library was wrong.
// Exact distances are of the corpus (tests/corpus), which two other exact solvers confirmed.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "pairs/judge_pairs.hpp"

namespace edgewise::cli_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

struct Posted {
    std::string name;
    double distance, depth;  ///< of contact the depth, else 0
};

const std::vector<Posted> thrown = {{"drake21673_convex1.txt", 0, 0.5747809100146696},
                                    {"drake21673_convex2.txt", 0, 0.8936538640120293},
                                    {"drake21673_convex3.txt", 0, 0.6343418689916047},
                                    {"fcl390.txt", 1.7082191684687607e-08, 0}};

TEST(Judge, SaysWhoWasWrongAboutWhatWasPosted) {
    for (const Posted& posted : thrown) {
        const Outcome outcome = judge(dump(posted.name));
        ASSERT_EQ(outcome.exit_code, 1) << posted.name << outcome.err;
        const json verdict = json::parse(outcome.out);
        EXPECT_EQ(verdict["format"], "FCL dump");
        EXPECT_THAT(verdict["wrong"], Contains("FCL, as reported")) << "it threw";
        for (const json& answer : verdict["answers"]) {
            const std::string who = answer["who"];
            if (who.find(" on ") != who.npos) {
                EXPECT_FALSE(answer["wrong"]) << posted.name << ": " << answer;
            }
        }
        const double exact = verdict["exact"]["distance"];
        EXPECT_DOUBLE_EQ(exact, posted.distance) << posted.name;
        if (posted.depth > 0) {
            EXPECT_NEAR(verdict["exact"]["depth"], posted.depth, 1e-12) << posted.name;
        }
        const json& proof = verdict["exact"]["certificate"];
        EXPECT_LE(proof["lower"], exact);
        EXPECT_GE(proof["upper"], exact);
    }
}

/// These cases do not contain the library's answer; the command line gives it.
TEST(Judge, TakesWhatALibrarySaid) {
    const json shallow = json::parse(judge(coal144).out);
    EXPECT_NEAR(shallow["exact"]["depth"], 1e-4, 1e-15);
    const Outcome apart = judge(coal685, {"--said", "coal=-0.1"});
    EXPECT_EQ(apart.exit_code, 1);
    const json verdict = json::parse(apart.out);
    EXPECT_NEAR(verdict["exact"]["distance"], 1.075 - 0.03 - (0.845416 + 0.37 / 2), 1e-14);
    EXPECT_EQ(verdict["wrong"][0], "coal, as reported");
    EXPECT_EQ(judge(coal685, {"--said", "coal=0.014584", "--peers", "none"}).exit_code, 2);
}

/// Farther apart than double precision computes with; of a program without other libraries, which would be
/// asked.
TEST(Judge, ThatComparedNothingSaysSo) {
    const Folder folder;
    const std::string bodies =
        R"({"id": "1", "a": {"vertices": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]}, )"
        R"("b": {"vertices": [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]}, "pose_b": {"t": [)";
    folder.write("far.json", bodies + "1e100,0,0]}}");
    folder.write("near.json", bodies + "3,0,0]}}");
    const auto judged = [&](const Arguments& arguments) {
        return Process(crooked_program_path, arguments, folder).wait();
    };
    const Outcome outcome = judged({"judge", "far.json"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.out, HasSubstr("nothing was compared"));
    EXPECT_THAT(outcome.out, testing::Not(HasSubstr("nobody is wrong")));
    EXPECT_EQ(json::parse(judged({"judge", "far.json", "--json"}).out)["compared"], false);
    const Outcome near = judged({"judge", "near.json", "--layouts", "straight"});
    EXPECT_EQ(near.exit_code, 0);
    EXPECT_THAT(near.out, HasSubstr("nobody is wrong"));
}

/// The exact answer, too, is about the rotation that was used.
TEST(Judge, UsesTheNearestRotationForAll) {
    const auto with = [](const json& r) {
        return json{
            {"id", "1"}, {"a", box(1, 1, 1)}, {"b", box(1, 1, 1)}, {"pose_b", {{"R", r}, {"t", {3, 0, 0}}}}}
            .dump();
    };
    const Outcome nearly = judge(with({1.0004, 0, 0, 0, 1.0004, 0, 0, 0, 1.0004}));
    EXPECT_EQ(nearly.exit_code, 0) << nearly.out;
    EXPECT_THAT(nearly.err, HasSubstr("pose_b.R is 0.0008 from a rotation; the nearest rotation is used"));
    EXPECT_EQ(lines_of(nearly.err).size(), 1U);
    EXPECT_EQ(json::parse(nearly.out)["exact"]["distance"], 2);
    EXPECT_LT(json::parse(nearly.out)["exact"]["band"], 1e-13);
    const Outcome scaled = judge(with({0.001, 0, 0, 0, 0.001, 0, 0, 0, 0.001}));
    EXPECT_EQ(scaled.exit_code, 2);
    EXPECT_EQ(scaled.out, "");
    EXPECT_THAT(scaled.err, HasSubstr("pose_b.R is 0.001 times a rotation: scale the vertices instead"));
}

/// The cube and the tetrahedron of FCL's issue 508: 3.1622776601683795 was answered where the distance is 3.
constexpr const char* fcl508 =
    R"({"id": "fcl508", "a": {"vertices": [[-0.5,-0.5,-0.5],[0.5,-0.5,-0.5],[-0.5,0.5,-0.5],[0.5,0.5,-0.5],)"
    R"([-0.5,-0.5,0.5],[0.5,-0.5,0.5],[-0.5,0.5,0.5],[0.5,0.5,0.5]]},)"
    R"( "b": {"vertices": [[0,3.5,0],[1,5,0],[-1,5,0],[0,5,1]]}})";

TEST(Judge, SaysByHowMuch) {
    const json verdict = json::parse(judge(fcl508, {"--said", "fcl=3.1622776601683795"}).out);
    const json& said = verdict["answers"].back();
    EXPECT_EQ(said["who"], "fcl, as reported");
    EXPECT_EQ(said["verdict"], "wrong distance");
    EXPECT_NEAR(said["error"], 0.1622776601683795, 1e-15);
    EXPECT_GT(said["beyond"], 0.16);
}

/// The case file that it prints is read again, and is the expected pair: the given one, or, if an available
/// peer is wrong on it, a smaller one that still shows the fault.
TEST(Judge, WritesACaseAndTestsForOthers) {
    const json first = json::parse(judge(dump("fcl390.txt"), {"--tests"}).out);
    EXPECT_THAT(first["tests"]["fcl"].get<std::string>(), HasSubstr("fcl::Convex<double> a("));
    EXPECT_THAT(first["tests"]["bullet"].get<std::string>(), HasSubstr("btGjkPairDetector"));
    const json second = json::parse(judge(first["case"].dump()).out);
    EXPECT_EQ(second["format"], "case line");
    EXPECT_EQ(second["exact"]["distance"], first["case"]["expect"]["distance"]);
    const json flat = json::parse(
        judge(R"({"id": "1", "a": {"vertices": [[0,0,0]]}, "b": {"vertices": [[1,2,2]]}})", {"--tests"}).out);
    EXPECT_EQ(flat["exact"]["distance"], 3);
    EXPECT_TRUE(flat["tests"]["fcl"].is_null());
}

/// A pair that all libraries answer right is printed as given.
TEST(Judge, GivesAnEasyCaseAsItIs) {
    const json first =
        json::parse(judge(R"({"id": "1", "a": {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]},)"
                          R"( "b": {"vertices": [[3,0,0],[4,0,0],[3,1,0],[3,0,1]]}})")
                        .out);
    EXPECT_EQ(first["exact"]["distance"], 2);
    EXPECT_EQ(first["case"]["expect"]["distance"], first["exact"]["distance"]);
    EXPECT_EQ(first["case"]["a"]["vertices"].size(), 4U);
}

TEST(Judge, TakesMeshesWithPoses) {
    const Folder folder;
    folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\n");
    folder.write("b.obj", "v 0.1 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n");
    const Outcome outcome =
        run({"judge", "--a", "a.obj", "--b", "b.obj", "--pose-b", "3,0,0", "--layouts", "aos_f64", "--json"},
            folder);
    ASSERT_NE(outcome.exit_code, 2) << outcome.err;
    const json same = json::parse(judge(R"({"id": "1", "a": {"vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,1]]},)"
                                        R"( "b": {"vertices": [[0.1,0,0],[1,0,0],[0,1,0],[0,0,1]]},)"
                                        R"( "pose_b": {"R": [1,0,0,0,1,0,0,0,1], "t": [3,0,0]}})")
                                      .out);
    EXPECT_EQ(json::parse(outcome.out)["exact"]["distance"], same["exact"]["distance"]);
    EXPECT_GT(same["exact"]["distance"], 1.9);
    for (const auto& [pose, why] :
         {std::pair{"0.001,0,0,3,0,0.001,0,0,0,0,0.001,0", "0.001 times a rotation"},
          {"1,0,0,3,0,1,0,0,0,0,1,0,0,0,0,2", "the fourth row"},
          {"3,0,0,", ""},
          {"3,0", "2 numbers"}}) {
        const Outcome posed =
            run({"judge", "--a", "a.obj", "--b", "b.obj", "--pose-b", pose, "--layouts", "aos_f64"}, folder);
        EXPECT_EQ(posed.exit_code == 2, *why != 0) << pose << posed.err;
        if (*why) {
            EXPECT_THAT(posed.err, testing::AllOf(HasSubstr("--pose-b"), HasSubstr(why)));
        }
    }
}

}  // namespace
}  // namespace edgewise::cli_test
