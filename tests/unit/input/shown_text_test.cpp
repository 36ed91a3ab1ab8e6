// SPDX-License-Identifier: MIT
//
// Names from elsewhere are shown whole, and nothing in them acts on who shows them.
#include "edgewise/input/shown_text.hpp"

#include <gmock/gmock.h>

#include "edgewise/input/json_text.hpp"

namespace edgewise::input {
namespace {

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
