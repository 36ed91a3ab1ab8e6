// SPDX-License-Identifier: MIT
//
// JSON from files: how deep it may go, and where it is wrong.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "edgewise/input/json_text.hpp"
#include "edgewise/input/shown_text.hpp"

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

using nlohmann::json;

std::string utf8(std::uint32_t code) {
    const auto byte = [](std::uint32_t value) { return std::string(1, static_cast<char>(value)); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) return byte(0xC0 | code >> 6) + byte(0x80 | (code & 0x3F));
    return byte(0xE0 | code >> 12) + byte(0x80 | (code >> 6 & 0x3F)) + byte(0x80 | (code & 0x3F));
}

bool must_not_act(std::uint32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x200E || code == 0x200F ||
           (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

TEST(ShownText, EveryControlCharacterAndMarkIsANumber) {
    std::size_t hidden = 0;
    for (std::uint32_t code = 0; code < 0xD800; ++code) {
        const std::string raw = utf8(code), text = "a" + raw + "b", line = shown_line(text);
        if (!must_not_act(code)) {
            if (line == text) continue;
            EXPECT_TRUE(code == 0x061C || code == 0x2028 || code == 0x2029) << code;
        } else {
            ++hidden;
        }
        EXPECT_EQ(line.find(raw), line.npos) << code;
        EXPECT_TRUE(line.starts_with(code < 0x80 ? "a\\x" : "a\\u") && line.ends_with("b")) << line;
        const std::string json_line = json_text(json(text));
        EXPECT_EQ(json_line.find(raw), json_line.npos) << code;
        EXPECT_EQ(json::parse(json_line), text) << "JSON keeps the character";
    }
    EXPECT_EQ(hidden, 32U + 33U + 2U + 5U + 4U);
    EXPECT_EQ(shown_line("a\x1b[31m\tb\n"), "a\\x1B[31m\\x09b\\x0A");
    EXPECT_EQ(shown_text("a\x1b\tb\r\nc\rd\n"), "a\\x1B\tb\r\nc\\x0Dd\n");
    EXPECT_EQ(shown_line("a\xe2\x80\xae"
                         "b"),
              "a\\u202Eb");
}

TEST(ShownText, BytesThatAreNoUtf8AreNumbers) {
    for (const auto& [raw, wanted] :
         std::vector<std::pair<std::string, std::string>>{{"bad\xff", "bad\\xFF"},
                                                          {"\xc3", "\\xC3"},
                                                          {"\xc0\x80", "\\xC0\\x80"},  // longer than it needs
                                                          {"\xed\xa0\x80", "\\xED\\xA0\\x80"},  // a surrogate
                                                          {"\xf4\x90\x80\x80", "\\xF4\\x90\\x80\\x80"},
                                                          {"\xe2\x82", "\\xE2\\x82"},
                                                          {"caf\xe9.json", "caf\\xE9.json"}}) {
        EXPECT_EQ(shown_line(raw), wanted);
        EXPECT_EQ(shown_text(raw), wanted);
        const std::string text = json_text(json{{raw, {raw, 1}}});
        EXPECT_EQ(json::parse(text), (json{{wanted, {wanted, 1}}}));
    }
    EXPECT_EQ(shown_line("caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"),
              "caf\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80");
    EXPECT_EQ(json_text(json{{"a", {1.5, nullptr, "x"}}}), R"({"a":[1.5,null,"x"]})");
}

TEST(ShownText, JsonOfAStoreIsNullWhereItIsNone) {
    EXPECT_EQ(json_or_null(R"({"a":1})")["a"], 1);
    EXPECT_TRUE(json_or_null("{").is_null());
    EXPECT_TRUE(json_or_null(std::string(40000, '[') + std::string(40000, ']')).is_null());
    EXPECT_TRUE(json_or_null("1e999").is_null());
}

}  // namespace

}  // namespace edgewise::input
