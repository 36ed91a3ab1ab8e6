// SPDX-License-Identifier: MIT
//
// JSON from files: how deep it may go, and where it is wrong.
#include "edgewise/input/json_text.hpp"

#include <gtest/gtest.h>

#include <string>

namespace edgewise::input {
namespace {

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
    EXPECT_EQ(parse_json("{]").error, "not JSON at column 2 (NaN and Infinity are not numbers)");
    EXPECT_EQ(parse_json("{\n  \"a\": NaN}").error,
              "not JSON at line 2, column 8 (NaN and Infinity are not numbers)");
    EXPECT_EQ(parse_json("[1e999]").error, "a number is too large for double precision");
    EXPECT_FALSE(parse_json(""));
    EXPECT_FALSE(parse_json("\"\xff\"")) << "no UTF-8";
}

}  // namespace
}  // namespace edgewise::input
