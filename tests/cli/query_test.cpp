// SPDX-License-Identifier: MIT
//
// `edgewise query`: one answer a line whatever the line holds, every key in each, bad lines named by file and
// number.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "pairs/query_pairs.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;

/// Overlapping is for bodies with much in common even where their faces lie in one plane or their corners
/// meet; touching is for bodies without common interior.
TEST_P(Query, AnswersSolidAndFlatBodiesApartAndInOneAnother) {
    const json point = {{"vertices", {{0.25, 0.25, 0.5}}}}, segment = {{"vertices", {{0, 0, 0}, {0, 0, 1}}}};
    struct Pair {
        const json& body;
        double x, y, z;
        const char* status;
        double distance;
    };
    const Pair pairs[] = {
        {tetrahedron, 3, 0, 0, "separated", 2},   {tetrahedron, 0.3, 0.2, 0.1, "overlapping", 0},
        {tetrahedron, 0, 0, 0, "overlapping", 0}, {tetrahedron, 0.25, 0, 0, "overlapping", 0},
        {tetrahedron, 1, 0, 0, "touching", 0},    {triangle, 3, 0, 0, "separated", 2},
        {segment, 2, 0, 0, "separated", 2},       {point, 1, 0, 0, "separated", 0.75},
        {point, 0, 0, 0, "touching", 0}};
    std::string cases;  // empty lines are no cases
    for (const Pair& pair : pairs) cases += pair_line("x", pair.body, pair.x, pair.y, pair.z) + "\n";
    const Outcome outcome = ask(cases);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    const auto answers = answers_of(outcome);
    ASSERT_EQ(answers.size(), std::size(pairs));
    for (std::size_t i = 0; i < answers.size(); ++i) {
        EXPECT_EQ(answers[i]["status"].get<std::string>(), pairs[i].status) << i;
        if (answers[i]["status"] != "touching") {
            EXPECT_EQ(answers[i]["distance"], pairs[i].distance) << i;
        }
    }
    EXPECT_EQ(answers[0]["point_a"], (json{1.0, 0.0, 0.0}));
    EXPECT_EQ(answers[0]["point_b"], (json{3.0, 0.0, 0.0}));
    EXPECT_EQ(answers[0]["feature_a"], (json{{"kind", "vertex"}, {"vertices", {1}}}));
    EXPECT_TRUE(answers[1]["point_a"].is_null());
}

TEST_P(Query, SaysWhetherBodiesAreNearerThanAMargin) {
    const std::string cases = pair_line("x", tetrahedron, 3) + pair_line("in", tetrahedron, 0.25);
    for (const double margin : {1.0, 10.0}) {
        const auto answers =
            answers_of(ask(cases, {"--needs", "nearer", "--margin", std::to_string(margin)}));
        ASSERT_EQ(answers.size(), 2u);
        const double size = std::sqrt(3.0);  // of a tetrahedron of unit legs
        EXPECT_NEAR(answers[0]["margin"].get<double>(), margin * size, 1e-6);
        EXPECT_EQ(answers[0]["nearer"], 2 < margin * size) << "2 apart";
        EXPECT_EQ(answers[1]["nearer"], true) << "they overlap";
        EXPECT_TRUE(answers[0]["distance"].is_null());
        const auto within = answers_of(ask(cases, {"--needs", "within", "--margin", std::to_string(margin)}));
        EXPECT_EQ(within[0]["nearer"], answers[0]["nearer"]);
        EXPECT_EQ(within[0]["distance"].is_null(), 2 >= margin * size) << "given where it is within";
        EXPECT_EQ(within[1]["distance"], 0);
    }
    EXPECT_NEAR(answers_of(ask(cases, {"--needs", "nearer"}))[0]["margin"].get<double>(),
                0.1 * std::sqrt(3.0), 1e-12);
}

/// Points at their origins have only the offset between them as their size. An offset with a vanishing
/// square, or, in single, one beyond its range, is refused; never answered with 0 or infinity.
TEST_P(Query, RefusesOffsetsThatThePrecisionCannotComputeWith) {
    const json point = {{"vertices", {{0, 0, 0}}}};
    const auto line = [&](const std::string& id, double x) {
        return json{{"id", id}, {"a", point}, {"b", point}, {"pose_b", moved(x, 0, 0)}}.dump() + "\n";
    };
    const std::string cases = line("denormal", 1e-307) + line("far", 1e12) + line("near", 2);
    for (const char* layout : {"aos_f64", "aos_f32"}) {
        const Outcome outcome = ask(cases, {"--layout", layout, "--needs", "certificate"});
        EXPECT_EQ(outcome.exit_code, 1);
        const auto answers = answers_of(outcome);
        ASSERT_EQ(answers.size(), 3u);
        EXPECT_EQ(answers[0]["status"], "failed") << layout;
        EXPECT_THAT(answers[0]["error"].get<std::string>(), HasSubstr("too small or too far apart"));
        EXPECT_TRUE(answers[0]["distance"].is_null() && answers[0]["certificate"].is_null());
        const bool single = std::string(layout) == "aos_f32";
        EXPECT_EQ(answers[1]["status"], single ? "failed" : "separated");
        if (single) {
            EXPECT_THAT(answers[1]["error"].get<std::string>(), HasSubstr("use f64"));
        }
        EXPECT_EQ(answers[2]["distance"], 2.0) << layout;
    }
}

TEST_P(Query, ProvesADepthAndADistance) {
    const auto answers =
        answers_of(ask(pair_line("apart", tetrahedron, 3) + pair_line("deep", tetrahedron, 0.25),
                       {"--needs", "certificate"}));
    ASSERT_EQ(answers.size(), 2u);
    EXPECT_LE(answers[0]["certificate"]["lower"], 2.0);
    EXPECT_GE(answers[0]["certificate"]["upper"], 2.0);
    EXPECT_NEAR(answers[0]["stored_certificate"]["lower"].get<double>(), 2.0, 1e-14);
    EXPECT_TRUE(answers[0]["depth"].is_null());
    EXPECT_EQ(answers[1]["status"], "overlapping");
    EXPECT_GT(answers[1]["depth"], 0.0);
    EXPECT_EQ(answers[1]["certificate"]["upper"], 0.0);
}

TEST_P(Query, TouchesWithinTheContactTolerance) {
    const std::string line = pair_line("near", tetrahedron, 1.125);
    EXPECT_EQ(answers_of(ask(line, {"--contact-tolerance", "0.125"}))[0]["status"], "touching");
    EXPECT_EQ(answers_of(ask(line, {"--contact-tolerance", "0.124"}))[0]["status"], "separated");
}

std::string with_matrix(const std::string& id, const json& r) {
    const json pose = {{"R", r}, {"t", {4, 0, 0}}};
    return json{{"id", id}, {"a", tetrahedron}, {"b", tetrahedron}, {"pose_b", pose}}.dump() + "\n";
}

/// Lines that are refused or cannot be answered, each in another way.
std::vector<std::string> bad_lines() {
    return {with_matrix("bad", {0, 0, 0, 0, 0, 0, 0, 0, 0}),
            with_matrix("bad", {0.001, 0, 0, 0, 0.001, 0, 0, 0, 0.001}),
            with_matrix("bad", {1000, 0, 0, 0, 1000, 0, 0, 0, 1000}),
            with_matrix("bad", {2, 0, 0, 0, 2, 0, 0, 0, 2}),
            with_matrix("bad", {1, 0, 0, 0, 1, 0, 1, 1, 0}),
            with_matrix("bad", {-0, 0.68, -0.64, 0.17, -0.62, -0.76, -0, -0.38, 0.09}),
            with_matrix("bad", {-1, 0, 0, 0, -1, 0, 0, 0, -1}),
            with_matrix("bad", {1e-300, 0, 0, 0, 1e-300, 0, 0, 0, 1e-300}),
            pair_line("bad", huge, 1),
            "{\"id\": \"bad\",\"a\":{\"vertices\":[]},\"b\":{\"vertices\":[]}}\n",
            "rubbish\n",
            "{\n",
            "{\"id\": \"bad\", \"b\n",
            std::string(1000, '[') + "\n",
            R"({"id":"bad","a":{"vertices":[[0,0,0]]},"b":{"vertices":[[1,0,0]]},"poseB":{"t":[1,0,0]}})"
            "\n"};
}

/// Each answer has every key; that of a bad line has only the file's name, the line's number and why.
void check_answer(const json& answer, bool is_bad, std::size_t line) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : answer.items()) keys.push_back(key);
    EXPECT_THAT(keys, testing::UnorderedElementsAre("id", "status", "distance", "point_a", "point_b",
                                                    "feature_a", "feature_b", "depth", "normal", "steps",
                                                    "fallbacks", "refinements", "escapes", "nearer", "margin",
                                                    "certificate", "stored_certificate", "error"));
    EXPECT_EQ(answer["status"] == "failed", is_bad) << answer;
    EXPECT_EQ(answer["error"].is_null(), !is_bad);
    EXPECT_EQ(answer["steps"].is_null(), is_bad);
    if (!is_bad) return;
    EXPECT_THAT(answer["error"].get<std::string>(), HasSubstr("cases.jsonl:" + std::to_string(line) + ": "));
    for (const char* key : {"distance", "point_a", "feature_a", "certificate", "nearer"})
        EXPECT_TRUE(answer[key].is_null()) << key;
}

/// Whatever is wrong with one line, and whatever is asked: all others are answered, and it is one refusal.
/// The first ten are said on stderr, with the number of the rest.
TEST_P(Query, OneBadLineTakesNoOtherWithIt) {
    const std::vector<std::string> bad = bad_lines();
    const std::string good = pair_line("good", tetrahedron, 3) + pair_line("good", tetrahedron, 0.25);
    std::string cases = good;
    for (const std::string& line : bad) cases += line + good;
    for (const char* needs :
         {"verdict", "witnesses", "features", "depth", "certificate", "nearer", "within"}) {
        SCOPED_TRACE(needs);
        const Outcome outcome = ask(cases, {"--needs", needs});
        EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
        const auto answers = answers_of(outcome);
        ASSERT_EQ(answers.size(), 3 * bad.size() + 2);
        for (std::size_t i = 0; i < answers.size(); ++i) check_answer(answers[i], i % 3 == 2, i + 1);
        const std::string asked = needs;
        const bool of_margin = asked == "nearer" || asked == "within";
        EXPECT_EQ(answers[0]["distance"].is_null(), of_margin || asked == "verdict");
        EXPECT_EQ(answers[0]["nearer"].is_null(), !of_margin);
        EXPECT_EQ(answers[2]["id"], "bad");
        const auto said = lines_of(outcome.err);
        ASSERT_EQ(said.size(), 11U) << outcome.err;
        for (std::size_t i = 0; i < 10; ++i)
            EXPECT_THAT(said[i], HasSubstr("cases.jsonl:" + std::to_string(3 * i + 3) + ": "));
        EXPECT_THAT(said.back(), HasSubstr("and 5 more: "));
        EXPECT_THAT(outcome.err, testing::Not(HasSubstr("memory")));
    }
    EXPECT_EQ(ask(bad[0] + bad[11]).exit_code, 2) << "no line could be read";
}

/// Digits as people print them: the answer is that of the nearest rotation, and lies in its own certificate.
TEST_P(Query, AnswersNearlyRotationsAsTheNearest) {
    std::string cases;
    for (const double off : {0.0, 1e-10, 4e-4})
        cases += with_matrix("x", {0, -(1 + off), 0, 1 + off, 0, 0, 0, 0, 1 + off});
    const Outcome outcome = ask(cases, {"--needs", "certificate"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const json& answer : answers_of(outcome))
        for (const json& value :
             {answer["distance"], answer["certificate"]["lower"], answer["certificate"]["upper"]})
            EXPECT_NEAR(value, 2, 1e-12);
    EXPECT_THAT(outcome.err, HasSubstr("cases.jsonl: 2 lines have a matrix that is nearly a rotation"));
}

INSTANTIATE_TEST_SUITE_P(Algorithm, Query, testing::Values("vclip", "gjk"),
                         [](const auto& of) { return std::string(of.param); });

}  // namespace
}  // namespace edgewise::cli_test
