// SPDX-License-Identifier: MIT
//
// JSON from files: how deep it may go, and where it is wrong.
#include "edgewise/input/json_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

namespace edgewise::input {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string nested(std::size_t levels) { return std::string(levels, '[') + std::string(levels, ']'); }

TEST(JsonText, IsReadToALimitedDepth) {
    EXPECT_TRUE(parse_json(nested(deepest_json)));
    const auto deeper = parse_json(nested(deepest_json + 1));
    ASSERT_FALSE(deeper);
    EXPECT_EQ(deeper.error, "nested deeper than 64 levels");
    EXPECT_FALSE(parse_json(nested(100'000)));
    EXPECT_FALSE(parse_json(std::string(100'000, '[')));
    EXPECT_FALSE(parse_json(std::string(5'000'000, '[')));
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += R"({"a":)";
    EXPECT_FALSE(parse_json(objects));
    EXPECT_FALSE(parse_json<nlohmann::ordered_json>(nested(100'000)));
}

TEST(JsonText, BracketsInTextsAreNoLevels) {
    const std::string brackets(1000, '[');
    EXPECT_EQ(nesting_of("{\"a\": \"" + brackets + "\"}"), 1U);
    EXPECT_EQ(nesting_of(R"(["\"[[[[", [1], "\\", [[2]]])"), 3U);
    EXPECT_EQ(nesting_of("]]]]["), 1U);
    EXPECT_TRUE(parse_json("{\"a\": \"" + brackets + "\"}"));
}

TEST(JsonText, SaysWhereItIsWrong) {
    EXPECT_EQ(parse_json("{]").error, "not JSON at column 2");
    EXPECT_EQ(parse_json("{\n  \"a\": NaN}").error,
              "not JSON at line 2, column 8 (NaN and Infinity are not numbers)");
    for (const char* no_number : {"NaN", "nan", "Infinity", "-Infinity", "inf", "-nan"})
        EXPECT_THAT(parse_json("[1, " + std::string(no_number) + "]").error,
                    HasSubstr("(NaN and Infinity are not numbers)"))
            << no_number;
    for (const char* text : {"[1, 2", "{'a': 1}", "[1,,2]", "[0x10]", "nothing", "[1] [2]"}) {
        const std::string error = parse_json(text).error;
        EXPECT_THAT(error, StartsWith("not JSON at column ")) << text;
        EXPECT_THAT(error, Not(HasSubstr("NaN"))) << text;
    }
    EXPECT_EQ(parse_json("[1e999]").error, "a number is too large for double precision");
    EXPECT_FALSE(parse_json(""));
    EXPECT_FALSE(parse_json("\"\xff\"")) << "no UTF-8";
}

TEST(JsonText, RefusesAMemberThatIsGivenTwice) {
    const std::vector<std::array<std::string, 2>> refused = {
        {R"({"a": 1, "a": 2})", "a"},
        {R"({"a": 1, "a": 1})", "a"},
        {R"({"a": 1, "b": 2, "\u0061": 3})", "a"},
        {R"({"a": {"t": [1], "R": 2, "t": [1]}})", "a.t"},
        {R"([{"x": 1}, {"y": [{"z": {}, "z": {}}]}])", "y.z"},
        {R"({"a": {"b": 1}, "c": 1, "a": {}})", "a"},
        {R"({"": 1, "": 2})", ""},
    };
    for (const auto& [text, path] : refused) {
        const std::string line = (path.empty() ? "''" : path) + " is given twice; keep one of them";
        EXPECT_EQ(parse_json(text).error, line) << text;
        EXPECT_EQ(parse_json<nlohmann::ordered_json>(text).error, line) << text;
    }
    // The same name in two objects, and a text that looks like a member.
    for (const char* text : {R"([{"a": 1}, {"a": 1}])", R"({"a": {"a": {"a": 1}}})",
                             R"({"a": {"t": 1}, "b": {"t": 1}, "t": 1})", R"({"a": "a", "b": ["a", "a"]})"})
        EXPECT_TRUE(parse_json(text)) << text;
}

TEST(JsonText, UnknownMembersAreRefusedWithTheNearestKnownOne) {
    const std::vector<std::string> known = {"id", "a", "b", "pose_a", "pose_b", "note"};
    const auto refused = [&](const char* text) {
        return unknown_member(*parse_json(text), "a case line", known);
    };
    EXPECT_EQ(
        refused(R"({"id": 1, "poseB": {}})"),
        "'poseB' is not a member of a case line; did you mean 'pose_b'? known: id, a, b, pose_a, pose_b, "
        "note");
    for (const auto& [wrong, near] : std::vector<std::array<std::string, 2>>{
             {"ID", "id"}, {"A", "a"}, {"POSE_B", "pose_b"}, {"pose-a", "pose_a"}, {"notes", "note"}})
        EXPECT_THAT(refused(("{\"" + wrong + "\": 1}").c_str()), HasSubstr("did you mean '" + near + "'?"));
    EXPECT_EQ(refused(R"({"colour": 1})"),
              "'colour' is not a member of a case line; known: id, a, b, pose_a, pose_b, note");
    EXPECT_THAT(refused(R"({"": 1})"), StartsWith("'' is not a member"));
    EXPECT_THAT(refused(R"({"a\nb": 1})"), StartsWith("'a?b' is not a member"));
    EXPECT_EQ(refused(R"({"note": "", "a": 1, "b": {"colour": 2}})"), "");
    EXPECT_EQ(refused("{}"), "");
}

}  // namespace
}  // namespace edgewise::input
