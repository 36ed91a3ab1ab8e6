// SPDX-License-Identifier: MIT
//
// `edgewise query`: one answer a line whatever the line holds, every key in each, bad lines named by file and
// number.
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pairs/query_pairs.hpp"

namespace edgewise::cli_test {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAre;

TEST_P(Query, AnswersSeparatedAndOverlappingPairs) {
    const Outcome outcome =
        ask(pair_line("apart", tetrahedron, 3) + "\n" + pair_line("into", tetrahedron, 0.3, 0.2, 0.1));
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
    const auto answers = answers_of(outcome);
    ASSERT_EQ(answers.size(), 2u);  // empty lines are no cases
    EXPECT_EQ(answers[0]["id"], "apart");
    EXPECT_EQ(answers[0]["status"], "separated");
    EXPECT_EQ(answers[0]["distance"], 2.0);
    EXPECT_EQ(answers[0]["point_a"], (json{1.0, 0.0, 0.0}));
    EXPECT_EQ(answers[0]["point_b"], (json{3.0, 0.0, 0.0}));
    EXPECT_EQ(answers[0]["feature_a"], (json{{"kind", "vertex"}, {"vertices", {1}}}));
    EXPECT_EQ(answers[1]["id"], "into");
    EXPECT_EQ(answers[1]["status"], "overlapping");
    EXPECT_EQ(answers[1]["distance"], 0.0);
    EXPECT_TRUE(answers[1]["point_a"].is_null());
}

TEST_P(Query, SaysTenBadLinesAndCountsTheRest) {
    std::string cases;
    for (int i = 0; i < 300; ++i) cases += "rubbish\n";
    const Outcome outcome = ask(cases);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(answers_of(outcome).size(), 300U) << "no line is lost";
    const auto said = lines_of(outcome.err);
    ASSERT_EQ(said.size(), 11U);
    EXPECT_THAT(said.back(), HasSubstr("and 290 more: 300 lines could not be read"));
}

TEST_P(Query, HasEveryKeyInEveryAnswer) {
    const Outcome outcome = ask(pair_line("good", tetrahedron, 3) + pair_line("huge", huge, 3) + "rubbish\n");
    const auto answers = answers_of(outcome);
    ASSERT_EQ(answers.size(), 3u);
    for (const json& answer : answers) {
        std::vector<std::string> keys;
        for (const auto& [key, value] : answer.items()) keys.push_back(key);
        EXPECT_THAT(keys, UnorderedElementsAre("id", "status", "distance", "point_a", "point_b", "feature_a",
                                               "feature_b", "depth", "normal", "steps", "fallbacks",
                                               "refinements", "escapes", "nearer", "margin", "certificate",
                                               "stored_certificate", "error"));
    }
    for (const char* key : {"distance", "point_a", "feature_a", "steps", "certificate"}) {
        EXPECT_TRUE(answers[1][key].is_null()) << key;
    }
    EXPECT_TRUE(answers[0]["error"].is_null());
    EXPECT_THAT(answers[1]["error"].get<std::string>(), HasSubstr("cases.jsonl:2: a: vertex 1"));
}

TEST_P(Query, GivesNullForWhatWasNotAskedFor) {
    const auto answers = answers_of(ask(pair_line("x", tetrahedron, 3), {"--needs", "verdict"}));
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0]["status"], "separated");
    for (const char* key : {"distance", "point_a", "point_b", "feature_a", "feature_b"}) {
        EXPECT_TRUE(answers[0][key].is_null()) << key;
    }
}

TEST_P(Query, SaysWhetherBodiesAreNearerThanAMargin) {
    const std::string cases = pair_line("x", tetrahedron, 3) + pair_line("in", tetrahedron, 0.25);
    for (const double margin : {0.1, 1.0, 10.0}) {
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
    EXPECT_TRUE(answers_of(ask(cases, {}))[0]["nearer"].is_null());
}

TEST_P(Query, NamesTheLineOfABadCaseAndGoesOn) {
    const std::string no_vertices = R"({"id":"none","a":{"vertices":[]},"b":{"vertices":[]}})"
                                    "\n";
    const Outcome outcome = ask(pair_line("first", tetrahedron, 3) + "{\"id\": \"cut\n" + no_vertices +
                                pair_line("last", tetrahedron, 4));
    EXPECT_EQ(outcome.exit_code, 1) << "two lines were answered";
    const auto messages = lines_of(outcome.err);
    ASSERT_EQ(messages.size(), 2u) << outcome.err;
    EXPECT_THAT(messages[0], HasSubstr("cases.jsonl:2: "));
    EXPECT_THAT(messages[1], HasSubstr("cases.jsonl:3: "));
    const auto answers = answers_of(outcome);
    ASSERT_EQ(answers.size(), 4u);
    EXPECT_EQ(answers[1]["status"], "failed");
    EXPECT_THAT(answers[1]["error"].get<std::string>(), HasSubstr("cases.jsonl:2: "));
    EXPECT_EQ(answers[2]["status"], "failed");
    EXPECT_EQ(answers[2]["id"], "none");
    EXPECT_EQ(answers[3]["id"], "last");
    EXPECT_EQ(answers[3]["distance"], 3.0);
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

/// Two bodies with much in common are overlapping even where their faces lie in one plane or their corners
/// meet; touching is for bodies without common interior.
TEST_P(Query, TellsOverlapFromTouchInSpecialPositions) {
    const auto answers =
        answers_of(ask(pair_line("same", tetrahedron, 0) + pair_line("along", tetrahedron, 0.25) +
                       pair_line("corner", tetrahedron, 1)));
    ASSERT_EQ(answers.size(), 3u);
    EXPECT_EQ(answers[0]["status"], "overlapping");
    EXPECT_EQ(answers[1]["status"], "overlapping");
    EXPECT_EQ(answers[2]["status"], "touching");
}

TEST_P(Query, AnswersForFlatBodies) {
    const json point = {{"vertices", {{0.25, 0.25, 0.5}}}};
    const json segment = {{"vertices", {{0, 0, 0}, {0, 0, 1}}}};
    const auto answers =
        answers_of(ask(pair_line("triangles", triangle, 3) + pair_line("segments", segment, 2) +
                       pair_line("points", point, 1) + pair_line("same", point, 0)));
    ASSERT_EQ(answers.size(), 4u);
    EXPECT_EQ(answers[0]["distance"], 2.0);
    EXPECT_EQ(answers[1]["distance"], 2.0);
    EXPECT_EQ(answers[2]["distance"], 0.75);
    EXPECT_EQ(answers[3]["status"], "touching");
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
    EXPECT_EQ(answers_of(ask(line))[0]["status"], "separated");
    EXPECT_EQ(answers_of(ask(line, {"--contact-tolerance", "0.125"}))[0]["status"], "touching");
    EXPECT_EQ(answers_of(ask(line, {"--contact-tolerance", "0.124"}))[0]["status"], "separated");
}

TEST_P(Query, SolvesWithEitherSolver) {
    const std::string line = pair_line("near", tetrahedron, 1.125);
    auto by_default = answers_of(ask(line)),
         by_johnson = answers_of(ask(line, {"--sub-distance", "johnson"}));
    EXPECT_EQ(answers_of(ask(line, {"--sub-distance", "cofactors"})), by_default);
    // The search in singles counts its first support points as a step.
    by_default[0].erase("steps");
    by_johnson[0].erase("steps");
    EXPECT_EQ(by_johnson, by_default);
    const auto unknown = ask(line, {"--sub-distance", "volumes"});
    EXPECT_EQ(unknown.exit_code, 2);
    EXPECT_THAT(unknown.err,
                HasSubstr("--sub-distance: unknown solver 'volumes'; known: cofactors, johnson"));
}

INSTANTIATE_TEST_SUITE_P(Algorithm, Query, testing::Values("vclip", "gjk"),
                         [](const auto& of) { return std::string(of.param); });

// `edgewise query` on files with bad lines, and with matrices that are no rotations or nearly so.

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
    for (const char* needs :
         {"verdict", "witnesses", "features", "depth", "certificate", "nearer", "within"}) {
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
