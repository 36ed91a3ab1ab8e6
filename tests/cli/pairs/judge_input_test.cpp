// SPDX-License-Identifier: MIT
//
// What `edgewise judge` reads, and says that it read.
#include <gmock/gmock.h>

#include <array>
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

/// For every turn about every kind of axis: the intended axis and angle.
TEST(JudgeInput, SaysTurnsByAxisAndAngle) {
    const Folder folder;
    for (const double degrees : {0.001, 1.0, 45.0, 90.0, 179.0, 179.99999, 180.0}) {
        for (const auto& [x, y, z] : std::vector<std::array<double, 3>>{
                 {1, 0, 0}, {0, 0, -1}, {0.6, 0, 0.8}, {-0.6, 0.8, 0}, {2 / 3.0, -2 / 3.0, 1 / 3.0}}) {
            const double angle = degrees / 180 * std::acos(-1.0), c = std::cos(angle), s = std::sin(angle),
                         d = 1 - c;
            const json r = {c + d * x * x,     d * x * y - s * z, d * x * z + s * y,
                            d * x * y + s * z, c + d * y * y,     d * y * z - s * x,
                            d * x * z - s * y, d * y * z + s * x, c + d * z * z};
            folder.write("pair.json", json{{"id", "1"},
                                           {"a", {{"vertices", {{0, 0, 0}}}}},
                                           {"b", {{"vertices", {{3, 0, 0}}}}},
                                           {"pose_a", {{"R", r}}}}
                                          .dump());
            const json read = json::parse(
                run({"judge", "pair.json", "--json", "--layouts", "aos_f64"}, folder).out)["read"]["pose_a"];
            EXPECT_NEAR(read["degrees"], degrees, 1e-9);
            const double sign = degrees == 180 && read["axis"][0].get<double>() * x < 0 ? -1 : 1;
            EXPECT_NEAR(read["axis"][0].get<double>() * sign, x, 1e-9) << degrees << " " << x << " " << y;
            EXPECT_NEAR(read["axis"][1].get<double>() * sign, y, 1e-9) << degrees << " " << x << " " << y;
            if (degrees < 180) {
                EXPECT_NEAR(read["axis"][2], z, 1e-9);
            }
        }
    }
}

TEST(JudgeInput, PrintsACaseToFillIn) {
    const Folder folder;
    const Outcome outcome = run({"judge", "--template"}, folder);
    EXPECT_EQ(outcome.exit_code, 0);
    ASSERT_EQ(lines_of(outcome.out).size(), 1U);
    const std::string pretty = json::parse(outcome.out).dump(4);
    for (const std::string& text : {outcome.out, pretty}) {
        const json verdict = json::parse(judge(text).out);
        EXPECT_EQ(verdict["exact"]["distance"], 1) << text;
        EXPECT_EQ(verdict["read"]["pose_b"]["degrees"], 90);
    }
    folder.write("cases.jsonl", outcome.out);
    EXPECT_EQ(run({"query", "cases.jsonl"}, folder).exit_code, 0);
}

}  // namespace
}  // namespace edgewise::cli_test
