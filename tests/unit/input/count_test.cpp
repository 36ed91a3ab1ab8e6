// SPDX-License-Identifier: MIT
//
// Counts and numbers: what a user may write, and every way to write what is none.
#include "edgewise/input/count.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace edgewise::input {
namespace {

using testing::HasSubstr;

constexpr CountRange thousand{1, 1000, "queries"};

TEST(Count, IsDigitsInRange) {
    EXPECT_EQ(*parse_count("1", thousand), 1U);
    EXPECT_EQ(*parse_count("1000", thousand), 1000U);
    EXPECT_EQ(*parse_count("007", thousand), 7U);
    EXPECT_EQ(*parse_count("18446744073709551615", seed_range), UINT64_MAX);
}

TEST(Count, RefusesWhatIsNoneWithRangeAndUnit) {
    std::vector<std::string> texts = {"", " ", " 5", "5 "};
    std::istringstream words(
        "0 1001 -1 +5 0x10 1e3 1.5 5.0 9223372036854775808 18446744073709551616 1e308 nan inf many 5,6 \xd9\xa5");
    for (std::string word; words >> word;) texts.push_back(word);
    for (const std::string& text : texts) {
        const auto count = parse_count(text, thousand);
        ASSERT_FALSE(count) << text;
        EXPECT_EQ(count.error, "'" + text + "' wants a whole number of queries, 1 to 1000");
    }
    EXPECT_FALSE(parse_count("18446744073709551616", seed_range)) << "2^64";
    EXPECT_FALSE(parse_count("-1", seed_range));
}

TEST(Count, OfJsonHasNoFraction) {
    using Json = nlohmann::json;
    EXPECT_EQ(*count_from(Json::parse("30"), thousand), 30U);
    EXPECT_EQ(*count_from(Json::parse("3e2"), thousand), 300U);
    EXPECT_EQ(*count_from(Json::parse("18446744073709551615"), seed_range), UINT64_MAX);
    for (const char* text : {"-1", "0", "1001", "1.5", "1e308", "-1e308", "9223372036854775808", "\"5\"",
                             "null", "true", "[]", "{}", "[[1]]"}) {
        const auto count = count_from(Json::parse(text), thousand);
        ASSERT_FALSE(count) << text;
        EXPECT_THAT(count.error, HasSubstr("wants a whole number of queries, 1 to 1000"));
    }
    EXPECT_FALSE(count_from(Json::parse("18446744073709551616"), seed_range)) << "2^64, read as a double";
    EXPECT_LT(count_from(Json::parse('"' + std::string(100'000, 'x') + '"'), thousand).error.size(), 120U);
}

TEST(Number, IsFiniteAndDecimal) {
    EXPECT_EQ(*parse_number("0.5"), 0.5);
    EXPECT_EQ(*parse_number("-1e-3"), -1e-3);
    for (const char* text : {"", " 1", "1 ", "+1", "0x10", "1e999", "nan", "inf", "-inf", "1,5", "half"})
        EXPECT_FALSE(parse_number(text)) << text;
}

TEST(Number, IsInItsRange) {
    const NumberRange seconds{5, 3600, "seconds"};
    EXPECT_EQ(*parse_number("5", seconds), 5);
    EXPECT_EQ(*parse_number("3.6e3", seconds), 3600);
    for (const char* text : {"4.999", "3600.1", "-5", "nan"})
        EXPECT_EQ(parse_number(text, seconds).error,
                  "'" + std::string(text) + "' wants a decimal number of seconds, 5 to 3600");
    EXPECT_FALSE(parse_number("0", above_0));
    EXPECT_TRUE(parse_number("1e-300", above_0));
    EXPECT_EQ(parse_number("-1", from_0).error, "'-1' wants a decimal number, 0 or more");
    EXPECT_EQ(parse_number("half").error, "'half' wants a decimal number");
}

}  // namespace
}  // namespace edgewise::input
