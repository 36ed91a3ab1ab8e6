// SPDX-License-Identifier: MIT
//
// What `edgewise judge` reads, and says that it read.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "pairs/judge_pairs.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;

/// A user sees what was read before any verdict, and also where there is none.
TEST(JudgeInput, SaysFirstWhatItRead) {
    const json read = json::parse(judge(coal685).out)["read"];
    EXPECT_EQ(read["a"]["vertices"], 8);
    EXPECT_EQ(read["b"]["extent"], (json{5.898, 0.06, 2.69}));
    EXPECT_EQ(read["b"]["low"], (json{-5.898 / 2, -0.03, -2.69 / 2}));
    EXPECT_EQ(read["pose_a"]["translation"], (json{1.490670, 0.845416, -0.194226}));
    EXPECT_NEAR(read["pose_a"]["degrees"], 120, 1e-12);
    EXPECT_NEAR(read["pose_a"]["axis"][0], -std::sqrt(1 / 3.0), 1e-15);
    EXPECT_EQ(read["pose_b"]["degrees"], 0);
    EXPECT_TRUE(read["pose_b"]["axis"].is_null());

    const Folder folder;
    folder.write("pair.json", coal144);
    folder.write("huge.json", R"({"id": "1", "a": {"vertices": [[0,0,0], [1e200,0,0], [0,1,0], [0,0,1]]},)"
                              R"( "b": {"vertices": [[0,0,0]]}, "pose_b": {"R": [-1,0,0,0,-1,0,0,0,1]}})");
    const std::string out = run({"judge", "pair.json", "--layouts", "aos_f64"}, folder).out;
    EXPECT_EQ(
        out.find(
            "read: case line\n  A: 8 vertices from (-1, -1, -1) to (1, 1, 1), extent 2 x 2 x 2\n     at the "
            "identity\n  B: 8 vertices from (-1, -1, -1) to (1, 1, 1), extent 2 x 2 x 2\n     at (1.9999, 0, "
            "0), not turned\nexact: "),
        0U)
        << out;
    const Outcome refused = run({"judge", "huge.json", "--layouts", "aos_f64"}, folder);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.out, HasSubstr("at (0, 0, 0), turned by 180 degrees about (0, 0, 1)"));
    EXPECT_THAT(refused.out, testing::Not(HasSubstr("exact")));
}

TEST(JudgeInput, PrintsACaseToFillIn) {
    const Folder folder;
    const Outcome outcome = run({"judge", "--template"}, folder);
    EXPECT_EQ(outcome.exit_code, 0);
    ASSERT_EQ(lines_of(outcome.out).size(), 1U);
    const json verdict = json::parse(judge(json::parse(outcome.out).dump(4)).out);
    EXPECT_EQ(verdict["exact"]["distance"], 1);
    EXPECT_EQ(verdict["read"]["pose_b"]["degrees"], 90);
    folder.write("cases.jsonl", outcome.out);
    EXPECT_EQ(run({"query", "cases.jsonl"}, folder).exit_code, 0);
}

}  // namespace
}  // namespace edgewise::cli_test
