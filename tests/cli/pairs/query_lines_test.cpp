// SPDX-License-Identifier: MIT
//
// `edgewise query` on files with bad lines, and with matrices that are no rotations or nearly so.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pairs/query_pairs.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;

class QueryLines : public Query {};

/// Lines that are refused or cannot be answered, each in another way.
std::vector<std::string> bad_lines() {
    const auto with_matrix = [](const json& r) {
        return json{{"id", "bad"},
                    {"a", tetrahedron},
                    {"b", tetrahedron},
                    {"pose_b", {{"R", r}, {"t", {50, 0, 0}}}}}
                   .dump() +
               "\n";
    };
    return {with_matrix({0, 0, 0, 0, 0, 0, 0, 0, 0}),
            with_matrix({0.001, 0, 0, 0, 0.001, 0, 0, 0, 0.001}),
            with_matrix({1000, 0, 0, 0, 1000, 0, 0, 0, 1000}),
            with_matrix({2, 0, 0, 0, 2, 0, 0, 0, 2}),
            with_matrix({1, 0, 0, 0, 1, 0, 1, 1, 0}),
            with_matrix({-0, 0.68, -0.64, 0.17, -0.62, -0.76, -0, -0.38, 0.09}),
            with_matrix({-1, 0, 0, 0, -1, 0, 0, 0, -1}),
            with_matrix({1e-300, 0, 0, 0, 1e-300, 0, 0, 0, 1e-300}),
            pair_line("bad", huge, 1),
            "rubbish\n",
            "{\n",
            "{\"id\": \"bad\", \"b\n",
            std::string(1000, '[') + "\n",
            R"({"id":"bad","a":{"vertices":[[0,0,0]]},"b":{"vertices":[[1,0,0]]},"poseB":{"t":[1,0,0]}})"
            "\n"};
}

/// Whatever is wrong with one line, and whatever is asked: all others are answered, and it is one refusal.
TEST_P(QueryLines, OneBadLineTakesNoOtherWithIt) {
    const std::vector<std::string> bad = bad_lines();
    const std::string good = pair_line("good", tetrahedron, 3) + pair_line("good", tetrahedron, 0.25);
    std::string cases = good;
    for (const std::string& line : bad) cases += line + good;
    for (const char* needs : {"verdict", "witnesses", "features", "depth", "certificate", "nearer"}) {
        const Outcome outcome = ask(cases, {"--needs", needs});
        EXPECT_EQ(outcome.exit_code, 1) << needs << outcome.err;
        const auto answers = answers_of(outcome);
        ASSERT_EQ(answers.size(), 3 * bad.size() + 2) << needs;
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const bool is_bad = i % 3 == 2;
            EXPECT_EQ(answers[i]["status"] == "failed", is_bad) << needs << answers[i];
            EXPECT_EQ(answers[i]["error"].is_null(), !is_bad);
            if (is_bad) {
                EXPECT_TRUE(answers[i]["distance"].is_null() && answers[i]["nearer"].is_null());
            }
        }
        EXPECT_THAT(outcome.err, testing::Not(HasSubstr("memory")));
    }
}

TEST_P(QueryLines, OneBadLineInFourThousand) {
    std::string cases;
    for (int i = 0; i < 4000; ++i) cases += pair_line(std::to_string(i), tetrahedron, i == 1234 ? 1e200 : 3);
    const Outcome outcome = ask(cases, {"--needs", "certificate"});
    EXPECT_EQ(outcome.exit_code, 1);
    const auto answers = answers_of(outcome);
    ASSERT_EQ(answers.size(), 4000U);
    EXPECT_EQ(std::ranges::count_if(answers, [](const json& answer) { return answer["status"] == "failed"; }),
              1);
    EXPECT_EQ(answers[1234]["status"], "failed");
    ASSERT_EQ(lines_of(outcome.err).size(), 1U);
    EXPECT_THAT(outcome.err, HasSubstr("cases.jsonl:1235: "));
}

/// Digits as people print them: the answer is that of the nearest rotation, and lies in its own certificate.
TEST_P(QueryLines, AnswersNearlyRotationsAsTheNearest) {
    std::string cases;
    for (const double off : {0.0, 1e-13, 1e-10, 1e-7, 1e-4, 4e-4}) {
        const json r = {0, -(1 + off), 0, 1 + off, 0, 0, 0, 0, 1 + off};
        cases +=
            json{
                {"id", "x"}, {"a", tetrahedron}, {"b", tetrahedron}, {"pose_b", {{"R", r}, {"t", {4, 0, 0}}}}}
                .dump() +
            "\n";
    }
    const Outcome outcome = ask(cases, {"--needs", "certificate"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const json& answer : answers_of(outcome)) {
        EXPECT_NEAR(answer["distance"], 2, 1e-12);
        EXPECT_NEAR(answer["certificate"]["lower"], 2, 1e-12);
        EXPECT_NEAR(answer["certificate"]["upper"], 2, 1e-12);
    }
    ASSERT_EQ(lines_of(outcome.err).size(), 1U) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("cases.jsonl: 4 lines have a matrix that is nearly a rotation"));
}

INSTANTIATE_TEST_SUITE_P(Algorithm, QueryLines, testing::Values("vclip", "gjk"),
                         [](const auto& of) { return std::string(of.param); });

}  // namespace
}  // namespace edgewise::cli_test
